# Model form: colours say which solid, everywhere alike.

set style line 1 lt 7 dt 1 lw 2.4
set style line 2 lt 5 dt 2 lw 1.6
set style line 3 lt 1 dt 1 lw 1.6
set style line 4 lt 2 dt 1 lw 1.6
set tmargin 5
solids = 'rigid small_strain c_v c_p'
title_of(k) = k == 1 ? 'rigid, c_p' : k == 2 ? 'c_v, small strain' : k == 3 ? 'c_v' : 'c_p, as the paper'

@panel_a
set tmargin 6
eval heading('a', 'what a kilogram of binder takes, heated evenly')
set xlabel 'T / K'
set ylabel 'heat per degree / (J/(kg K))'
set xrange [300:970]
set yrange [0:*]
plot data_capacity using 1:2 with lines ls 1 title 'free to expand: c_p', \
     '' using 1:3 with lines ls 4 title 'c_{p}  and stress work', \
     '' using 1:4 with lines lt 8 dt 3 lw 1.6 title 'c_v', \
     data_heated_c_p using 1:2 with points lt 2 pt 6 ps 0.8 title 'block in the solver, c_p', \
     data_heated_c_v using 1:2 with points lt 1 pt 4 ps 0.8 title 'block in the solver, c_v'

@panel_b
set tmargin 5
eval heading('b', 'slab of binder, 100 cal/(s cm^2), 0.45 cm/s')
set xlabel 'depth below the surface / µm'
set ylabel 'T / K'
set xrange [0:120]
set yrange [*:*]
plot data_slab_three_alpha using 1:2 with lines ls 1 title title_of(1), \
     '' using 1:3 with lines ls 2 title title_of(2), \
     '' using 1:4 with lines ls 3 title 'c_v, β = 3 α K', \
     '' using 1:5 with lines ls 4 title 'c_p, β = 3 α K', \
     data_slab_alpha using 1:4 with lines ls 3 dt 4 title 'c_v, β = α K', \
     '' using 1:5 with lines ls 4 dt 4 title 'c_p, β = α K'

set xlabel 't / ms'

@panel_c
eval heading('c', 'sandwich: mean burn rate')
set ylabel 'mean r_{b}  / (cm/s)'
set xrange [0:*]
set yrange [0:*]
plot for [k = 1:4] value('data_sandwich_' . word(solids, k)) using 1:2 with lines ls k title title_of(k)

set xrange [0:until]

@panel_d
eval heading('d', 'pack: mean burn rate, and its mean from 20 ms on')
plot for [k = 1:4] value('data_pack_' . word(solids, k)) using 1:2 with lines ls k \
         title sprintf('%s: %.3f cm/s', title_of(k), value('rate_' . word(solids, k)))

@panel_e
eval heading('e', 'pack: largest temperature, and its mean from 20 ms on')
set ylabel 'T / K'
set xrange [since:until]
set yrange [*:*]
plot for [k = 1:4] value('data_pack_' . word(solids, k)) using 1:3 with lines ls k \
         title sprintf('%s: %.1f K', title_of(k), value('hottest_' . word(solids, k)))

@panel_f
eval heading('f', 'parts of what stress changes: surface temperature of slabs, burn rate of sandwich and pack')
unset xlabel
set ylabel 'share of the whole change / %'
set bmargin 7
set xrange [-0.6:5.6]
set yrange [*:*]
unset xtics
set xtics scale 0 ()
name(k) = value(sprintf('bar_%d', k)) . "\nβ = " . value(sprintf('reading_%d', k)) . "\n" . value(sprintf('whole_%d', k))
do for [k = 0:5] { set xtics add (name(k) k) }
set xzeroaxis lw 1 dt 1 lc rgb 'black'
set ytics 20
set style fill solid 0.85 noborder
plot data_parts using 1:(0):($1 - 0.3):($1 + 0.3):(0):2 with boxxyerror lt 2 title 'capacity counted twice', \
     '' using 1:2:($1 - 0.3):($1 + 0.3):2:($2 + $3) with boxxyerror lt 1 title 'stretch at constant density', \
     '' using 1:(0):($1 - 0.3):($1 + 0.3):4:(0) with boxxyerror lt 5 title 'mechanics proper'
