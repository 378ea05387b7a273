# Figure 13: four maps side by side, all in the laboratory. Their places are fractions of the panel.

@map_axes
set xlabel 'x / µm'
set xrange [-width / 2:width / 2]
set yrange [bottom:5]
set xtics -60, 60, 60
set ytics 100
set contour base
set cntrparam levels discrete 0.5
set cntrlabel onecolor
set bmargin at screen foot_side
set tmargin at screen foot_side + map_height

hidden = '#ff000000'  # what stands on all four would be drawn four times

four_maps = "\
set multiplot; \
do for [k = 1:4] { \
    set lmargin at screen left_side + (k - 1) * map_side; \
    set rmargin at screen left_side + k * map_side - 0.012; \
    set title value(sprintf('time%d', k)); \
    if (k == 1) { set ylabel 'y / µm' offset -1,0; set ytics format '%g' } else { unset ylabel; set ytics format '' }; \
    if (k == 4) { set colorbox } else { unset colorbox }; \
    do for [l = 100:101] { set label l textcolor rgb (k > 1 ? hidden : l == 100 ? grey : 'black') }; \
    splot value(sprintf('data_%s%d', table, k)) using 1:2:field with pm3d nocontour, \
          value(sprintf('data_nodes%d', k)) using 1:2:4 with lines nosurface lw 0.5 lc rgb outline \
}; \
unset multiplot"

@panel_a
table = 'nodes'; field = 3; outline = 'white'
set label 101 'a   temperature' at screen 0.01, screen 0.98 left
set cblabel 'T / K' offset 1,0
@viridis
@colours_nodes1
set cbrange [300:largest_temperature]
@four_maps

@panel_b
table = 'cells'; field = 3; outline = 'grey40'
set label 101 'b   pressure'
set cblabel 'p / MPa' offset 1,0
@diverging
@colours_cells1
most = largest_pressure
@symmetric
@four_maps

@panel_c
table = 'cells'; field = 4; outline = 'white'
set label 101 'c   strain norm'
set cblabel '|E|' offset 1,0
@viridis
set cbrange [0:largest_strain]
@four_maps
