# Figure 12: the box of the pack (solid line), the window of the burning (dashed).

set xrange [-width / 2:width / 2]
set yrange [-period:0]
eval map_place(left_side, right_side, foot_side, head_side)
@map_frame
set xtics width / 4
set ytics 120
set xlabel 'x / µm'
set ylabel 'y / µm'
set style line 1 lc rgb '#d55e00' lw 1.6 dt 2
set key on at graph 0, graph 1.01 left bottom vertical

# Lighter discs are smaller.
share(r) = (r - smallest_radius) / (largest_radius - smallest_radius)
mixed(light, dark, r) = int(light + (dark - light) * share(r))
colour(r) = 65536 * mixed(0xc4, 0x4d, r) + 256 * mixed(0xdf, 0x8f, r) + mixed(0xee, 0xb5, r)

@panel_a
eval heading('a', sprintf('%g discs of AP in binder', count))
set style fill solid 1.0 border lc rgb '#404040'
plot data_discs using 1:2:3:(colour(column(3))) with circles lc rgb variable notitle, \
     -depth with lines ls 1 title 'bottom of the window at t = 0'

@panel_b
set multiplot
@map_only
unset key
set palette defined (0 '#ffffff', 1 '#4d8fb5')
set cbrange [0:1]
set cblabel 'volume fraction of AP'
@colours_fraction
splot data_fraction using 1:2:3 with pm3d
@map_frame
set xtics width / 4
set ytics 120
set xlabel 'x / µm'
set ylabel 'y / µm'
set key on
eval heading('b', 'as the grid sees them')
@small_print
plot -depth with lines ls 1 title 'bottom of the window at t = 0'
unset multiplot
