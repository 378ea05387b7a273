# Figure 1: the rows of nodes from side to side, the sides of the columns of cells, nodes and centres on top.

set border 15
unset grid
set size ratio -1
set xlabel 'x / µm'
set xtics 60
set ytics 60
set xrange [-1.05 * width / 2:1.05 * width / 2]
set yrange [-depth - amplitude - 15:amplitude + 15]
set lmargin at screen 0.24
set rmargin at screen 0.96
set tmargin at screen 0.92
set bmargin at screen 0.125
set style line 1 lc rgb '#808080' lw 0.8
set style line 2 lc rgb '#d55e00' lw 2.6
set style line 3 lt 1 pt 7 ps 0.55
set style line 4 lt 3 pt 2 ps 0.6 lw 1.4

@panel_a
eval heading('a', 'computational grid')
set ylabel 'η̂ / µm'
plot data_uniform using 1:2 with lines ls 1 notitle, \
     data_sides using 1:(-depth):(0):(depth) with vectors nohead ls 1 notitle, \
     data_uniform every :::rows::rows using 1:2 with lines ls 2 notitle

@panel_b
eval heading('b', 'the same, clustered, below y = φ')
set ylabel 'y / µm'
plot data_mapped using 1:2 with lines ls 1 notitle, \
     data_sides using 1:2:(0):(column(3) - column(2)) with vectors nohead ls 1 notitle, \
     data_mapped every :::rows::rows using 1:2 with lines ls 2 notitle

@panel_c
eval heading('c', 'near the surface')
set lmargin at screen 0.13
set rmargin at screen 0.97
set tmargin at screen 0.85
set bmargin at screen 0.13
set key maxcols 2
set xrange [12:80]
set yrange [-42:36]
set xtics 20
set ytics 20
plot data_mapped using 1:2 with lines ls 1 title 'edges of cells', \
     data_sides using 1:2:(0):(column(3) - column(2)) with vectors nohead ls 1 notitle, \
     data_mapped every :::rows::rows using 1:2 with lines ls 2 title 'burning surface, y = φ', \
     data_nodes using 1:2 with points ls 3 title 'nodes: T, v, ξ', \
     data_centres using 1:2 with points ls 4 title 'cells: σ, F, E'
