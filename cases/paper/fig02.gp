# Figure 2: cells of the hat function. The nine nodes stand in the tables row by row from the lower left.

eval map_place(0.16, 0.78, 0.19, 0.90)
set xlabel 'x / µm'
set ylabel 'y / µm'
stats data_q1 using 1 name 'X' nooutput
stats data_q1 using 2 name 'Y' nooutput
xs = ''
ys = ''
stats data_q1 using (xs = xs . sprintf(' %.9g', column(1)), ys = ys . sprintf(' %.9g', column(2)), 0) nooutput
node_x(k) = word(xs, k) + 0.0
node_y(k) = word(ys, k) + 0.0
stats data_q1 using (abs(column(3))) name 'Q' nooutput
stats data_bbar using (abs(column(3))) name 'B' nooutput
w = X_max - X_min
h = Y_max - Y_min
# One scale for both: the plot is as wide as 0.62 of the panel, as high as 0.71.
set yrange [Y_min - 0.15 * h:Y_max + 0.15 * h]
span = 1.3 * h * 0.62 / 0.71 * panel_ratio
set xrange [node_x(5) - span / 2:node_x(5) + span / 2]
set style line 1 lc rgb '#606060' lw 1

# The edges of the four cells.
edges = "\
do for [r = 0:2] { do for [c = 1:2] { \
    k = 3 * r + c; \
    set arrow k from node_x(k), node_y(k) to node_x(k + 1), node_y(k + 1) nohead back ls 1 \
} }; \
do for [c = 1:3] { do for [r = 0:1] { \
    k = 3 * r + c; \
    set arrow 10 + k from node_x(k), node_y(k) to node_x(k + 3), node_y(k + 3) nohead back ls 1 \
} }"

@panel_a
set multiplot
@map_only
@viridis
set cblabel 'ψ'
@colours_hat
splot data_hat using 1:2:3 with pm3d
@map_frame
set xtics w / 2 format '%.5g'
set xlabel 'x / µm'
set ylabel 'y / µm'
eval heading('a', 'hat function ψ_{i,j} and its cells')
@small_print
set label 6 '(i, j)' at node_x(5), node_y(5) right offset -0.5,-1.0 front tc rgb 'black'
do for [r = 0:1] { do for [c = 1:2] {
    k = 3 * r + c
    set label 1 + 2 * r + c sprintf('S_%d', 2 * r + c) at \
        0.25 * (node_x(k) + node_x(k + 1) + node_x(k + 3) + node_x(k + 4)), \
        0.25 * (node_y(k) + node_y(k + 1) + node_y(k + 3) + node_y(k + 4)) center front tc rgb 'white'
} }
@edges
plot data_q1 using 1:2 with points pt 7 ps 0.8 lc rgb 'black'
unset multiplot

# Couplings: area of a disc as its size, vermilion pulls, blue pushes back.
do for [l = 1:6] { unset label l }
eval map_place(0.16, 0.98, 0.19, 0.90)
set xrange [node_x(5) - span * 0.82 / 0.62 / 2:node_x(5) + span * 0.82 / 0.62 / 2]
size(v) = 0.4 + 3.0 * sqrt(abs(v) / most)
colour(v) = v > 0 ? 0xd55e00 : 0x0072b2
text(v) = gprintf(v > 0 ? '+%.3g' : '%.3g', v)
couplings = "plot field using 1:2:(size(column(3))):(colour(column(3))) with points pt 7 ps variable lc rgb variable, \
     '' using 1:2:(text(column(3))) with labels left offset 2.2,1.0"

@panel_b
eval heading('b', 'A_{uu} / GPa, the paper''s element (q1)')
most = Q_max
field = data_q1
@couplings

@panel_c
eval heading('c', 'A_{uu} / GPa, B-bar')
most = B_max
field = data_bbar
@couplings
