# Figure 14: the uppermost part of the pack.

@map_axes
set xlabel 'x / µm' offset 0,0.6
set ylabel 'y / µm' offset -1,0
set xrange [-width / 2:width / 2]
set yrange [bottom:top]
set xtics 40 offset 0,0.2
set ytics 20
set contour base
set cntrparam levels discrete 0.5
set cntrlabel onecolor
set lmargin at screen left_side
set rmargin at screen right_side
set bmargin at screen foot_side
set tmargin at screen head_side

@panel_a
set title 'a   temperature'
set cblabel 'T / K' offset 1,0
@viridis
@colours_nodes
set cbrange [lowest_temperature:largest_temperature]
splot data_nodes using 1:2:3 with pm3d nocontour, data_nodes using 1:2:4 with lines nosurface lw 0.7 lc rgb 'white'

@panel_b
set title 'b   pressure'
set cblabel 'p / MPa' offset 1,0
@diverging
@colours_cells
most = largest_pressure
@symmetric
splot data_cells using 1:2:3 with pm3d nocontour, data_nodes using 1:2:4 with lines nosurface lw 0.7 lc rgb 'grey40'

@panel_c
set title 'c   strain norm'
set cblabel '|E|' offset 1,0
@viridis
set cbrange [0:largest_strain]
splot data_cells using 1:2:4 with pm3d nocontour, data_nodes using 1:2:4 with lines nosurface lw 0.7 lc rgb 'white'
