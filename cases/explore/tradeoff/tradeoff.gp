# Speed for accuracy: colours and marks say what kind of knob a point turns; the line joins what nothing beats.

set style line 1 lt 8 pt 7 ps 1.3
set style line 2 lt 1 pt 4 ps 0.8
set style line 3 lt 2 pt 6 ps 0.8
set style line 4 lt 3 pt 8 ps 0.9
set style line 5 lt 5 pt 10 ps 0.9
set style line 6 lt 7 pt 2 ps 0.8
set style line 9 lc rgb '#606060' lw 1.4 dt 1
knobs = "'as it is' 'grid' 'step' 'solvers' 'scheme of a part' 'several at once'"

unset offsets
set logscale xy 10
set format x '%g'
set format y '%g'
set grid xtics ytics
set tmargin 4
set bmargin 5
set key outside right top vertical maxcols 1
set xlabel 'CPU time / s'
set ylabel 'V off by / %'
set yrange [1e-4:200]
floor_of(e) = e < 1.2e-4 ? 1.2e-4 : e
band(subject) = value('band_' . subject) > 0 ? "band_" . subject . " with filledcurves y1=1e-4 fc rgb '#eeeeee' title 'known no better', " : ''
lost(subject) = value('lost_' . subject) > 0 ? ", data_" . subject . "_lost using 1:(100) with points lc rgb '#b2182b' pt 1 ps 1.1 title 'refused, failed'" : ''
trade(subject) = 'plot ' . band(subject) . "data_" . subject . "_front_0 using 1:(floor_of($2)) with lines ls 9 title 'nothing beats', \
    for [k in kinds_" . subject . "] data_" . subject . " using ($1 == int(k) ? $2 : NaN):(floor_of($3)) with points ls int(k) + 1 title word(knobs, int(k) + 1)" . lost(subject)

@panel_a
eval heading('a', 'slab of AP, 160 ms, against the exact slab')
eval trade('slab')

@panel_b
eval heading('b', 'rigid sandwich, 80 ms, against the free-boundary problem')
eval trade('sandwich_rigid')

@panel_c
eval heading('c', 'sandwich with stress, against the finest run')
eval trade('sandwich')

@panel_d
eval heading('d', 'pack with stress, against the finest run')
eval trade('pack')

set ylabel 'off by / % (profile: µm)'
names = "'V' 'mean burn rate' 'max T' 'strain, 5 µm' 'pressure, 5 µm' 'profile / µm'"

@panel_e
eval heading('e', 'sandwich: what nothing beats, for each answer')
plot for [q = 0:5] value('data_sandwich_front_' . q) using 1:(floor_of($2)) with linespoints lt q + 1 pt q + 4 title word(names, q + 1)

@panel_f
eval heading('f', 'pack: what nothing beats, for each answer')
plot for [q = 0:5] value('data_pack_front_' . q) using 1:(floor_of($2)) with linespoints lt q + 1 pt q + 4 title word(names, q + 1)
