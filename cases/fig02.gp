# Figure 2: cells of the hat function. The nine nodes stand in the tables row by row from the lower left.

@map_axes
unset border
set xlabel 'x / µm'
set ylabel 'y / µm'
set xtics nomirror
set ytics nomirror
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
set xrange [X_min - 0.3 * w:X_max + 0.3 * w]
set yrange [Y_min - 0.15 * h:Y_max + 0.15 * h]
set xtics w / 2 format '%.1f'
set border 15
set tmargin at screen 0.92
set bmargin at screen 0.17
set ylabel 'y / µm' offset -1,0
set style line 1 lc rgb '#606060' lw 1

# The edges of the four cells.
tag = 1
do for [r = 0:2] { do for [c = 1:2] {
    k = 3 * r + c
    set arrow tag from node_x(k), node_y(k) to node_x(k + 1), node_y(k + 1) nohead front ls 1
    tag = tag + 1
} }
do for [c = 1:3] { do for [r = 0:1] {
    k = 3 * r + c
    set arrow tag from node_x(k), node_y(k) to node_x(k + 3), node_y(k + 3) nohead front ls 1
    tag = tag + 1
} }

@panel_a
set title 'a   hat function ψ_{i,j} and its cells'
set cblabel 'ψ'
do for [r = 0:1] { do for [c = 1:2] {
    k = 3 * r + c
    set label 1 + 2 * r + c sprintf('S_%d', 2 * r + c) at \
        0.25 * (node_x(k) + node_x(k + 1) + node_x(k + 3) + node_x(k + 4)), \
        0.25 * (node_y(k) + node_y(k + 1) + node_y(k + 3) + node_y(k + 4)) center front tc rgb 'white'
} }
set label 20 '(i, j)' at node_x(5), node_y(5) center offset 0,1.0 front tc rgb 'black'
@viridis
@colours_hat
splot data_hat using 1:2:3 with pm3d, data_q1 using 1:2:(0) with points pt 7 ps 0.8 lc rgb 'black'

# Couplings: area of a disc as its size, vermilion pulls, blue pushes back.
unset pm3d
do for [l = 2:5] { unset label l }
unset label 20
unset colorbox
set xtics offset 0,0
set xlabel offset 0,0
set ylabel offset 0,0
set rmargin at screen 0.95
set style textbox opaque noborder margins 0.4,0.2
size(v) = 0.4 + 3.6 * sqrt(abs(v) / most)
colour(v) = v > 0 ? 0xd55e00 : 0x0072b2
text(v) = sprintf('%+.3g', v)

@panel_b
set title 'b   A_{uu} / GPa, the paper''s element (q1)'
most = Q_max
plot data_q1 using 1:2:(size(column(3))):(colour(column(3))) with points pt 7 ps variable lc rgb variable notitle, \
     '' using 1:2:(text(column(3))) with labels boxed offset 3.6,1.1 notitle

@panel_c
set title 'c   A_{uu} / GPa, B-bar'
most = B_max
plot data_bbar using 1:2:(size(column(3))):(colour(column(3))) with points pt 7 ps variable lc rgb variable notitle, \
     '' using 1:2:(text(column(3))) with labels boxed offset 3.6,1.1 notitle
