# Figure 12: the box of the pack (solid line), the window of the burning (dashed).

@map_axes
set xlabel 'x / µm' offset 0,1.0
set ylabel 'y / µm' offset -1.5,0
set xtics 60
set ytics 120
set xrange [-width / 2:width / 2]
set yrange [-period:0]
set lmargin at screen 0.25
set rmargin at screen 0.75
set bmargin at screen 0.12
set tmargin at screen 0.95
set arrow 1 from -width / 2, -depth to width / 2, -depth nohead front dt 2 lw 1.6 lc rgb '#d55e00'

@panel_a
set title 'a   discs of AP in binder'
set xlabel 'x / µm' offset 0,0
set ylabel 'y / µm' offset 0,0
set xtics offset 0,0
unset colorbox
colour(r) = r > 35 ? 0x4d8fb5 : r > 25 ? 0x7fb3d0 : 0xb5d6e8
set style fill solid 1.0 border lc rgb '#404040'
plot data_discs using 1:2:3:(colour(column(3))) with circles lc rgb variable notitle

@panel_b
set title 'b   as the grid sees it'
set xlabel 'x / µm' offset 0,1.4
set xtics offset 0,1.2
set ylabel 'y / µm' offset -2.5,0
set ytics offset -1.8,0
set colorbox
set cblabel 'volume fraction of AP'
set palette defined (0 '#ffffff', 1 '#4d8fb5')
set cbrange [0:1]
@colours_fraction
splot data_fraction using 1:2:3 with pm3d
