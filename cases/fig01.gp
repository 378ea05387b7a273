# Figure 1: grid lines as drawn by splot, nodes and centres on top. The thick line is the surface.

@map_axes
unset colorbox
set border 15
set xrange [-126:126]
set xtics 60
set ytics 60
set tmargin at screen 0.93
set bmargin at screen 0.15
set lmargin at screen 0.24
set rmargin at screen 0.96
set style line 1 lc rgb '#808080' lw 0.8
set style line 2 lc rgb '#d55e00' lw 2.6
set style line 3 lt 1 pt 7 ps 0.55
set style line 4 lt 3 pt 2 ps 0.6 lw 1.4

@panel_a
set title 'a   computational grid'
set xlabel 'x / µm'
set ylabel 'η̂ / µm' offset -2.2,0
set yrange [-530:40]
splot data_uniform using 1:2:(0) with lines ls 1 notitle, \
      data_uniform every :::24::24 using 1:2:(0) with lines ls 2 notitle

@panel_b
set title 'b   the same, below the surface'
set ylabel 'y / µm' offset -2.2,0
splot data_mapped using 1:2:(0) with lines ls 1 notitle, \
      data_mapped every :::24::24 using 1:2:(0) with lines ls 2 notitle

@panel_c
set title 'c   near the surface'
set key outside right top vertical Left reverse samplen 2 spacing 1.4
set lmargin at screen 0.12
set rmargin at screen 0.66
set bmargin at screen 0.17
set xrange [12:80]
set yrange [-42:36]
set xtics 20
set ytics 20
splot data_mapped using 1:2:(0) with lines ls 1 title 'edges of cells', \
      data_mapped every :::24::24 using 1:2:(0) with lines ls 2 title 'burning surface, y = φ', \
      data_nodes using 1:2:(0) with points ls 3 title 'nodes: T, v, ξ', \
      data_centres using 1:2:(0) with points ls 4 title 'cells: σ, F, E'
