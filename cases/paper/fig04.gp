# Figure 4: near the surface. Points are the solver's, lines exact.

set xlabel 'depth below the surface / µm'
set ylabel 'T / K'
set style line 1 lt 7 pt 6 ps 0.7 lw 1.2 dt 1
set style line 2 lt 1 pt 4 ps 0.7 lw 1.2 dt 2
set style line 3 lt 2 pt 8 ps 0.8 lw 1.2 dt 4
set samples 2
title_of(k) = k == 1 ? 'thermal only' : k == 2 ? 'β = α K' : 'β = 3 α K'
table_of(k) = word('thermal alpha three_alpha', k)

stats data_binder_thermal using 1 name 'N' nooutput
sparse = N_records > 97 ? 4 : N_records > 49 ? 2 : 1  # near the surface of AP all are shown

@panel_a
eval heading('a', sprintf('AP, %g cal/(s cm^2)', flux_AP))
set xrange [0:8]
plot for [k = 1:3] value('data_exact_AP_' . table_of(k)) using 1:2 with lines ls k notitle, \
     for [k = 1:3] value('data_AP_' . table_of(k)) using 1:2 with points ls k notitle, \
     for [k = 1:3] NaN with linespoints ls k title title_of(k)

@panel_b
eval heading('b', sprintf('binder, %g cal/(s cm^2)', flux_binder))
set xrange [0:60]
plot for [k = 1:3] value('data_exact_binder_' . table_of(k)) using 1:2 with lines ls k notitle, \
     for [k = 1:3] value('data_binder_' . table_of(k)) every sparse::(N_records - 1) % sparse using 1:2 with points ls k notitle, \
     for [k = 1:3] NaN with linespoints ls k title title_of(k)
