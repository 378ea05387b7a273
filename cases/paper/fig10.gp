# Figure 10: thermal solid, thermo-mechanical dashed.

set style line 1 lt 1 dt 1
set style line 2 lt 2 dt 2

@panel_a
eval heading('a', 'steady surface temperature')
set xlabel 'x / µm'
set ylabel 'T_{s}  / K'
set autoscale xfix
set xtics 40
plot data_surface_thermal using 1:2 with lines ls 1 title 'thermal', \
     data_surface_coupled using 1:2 with lines ls 2 title 'thermo-mechanical'

@panel_b
eval heading('b', 'mean burn rate')
set xlabel 't / ms'
set ylabel 'mean r_{b}  / (cm/s)'
set xtics autofreq
set xrange [0:*]
set yrange [0:*]
plot data_rate_thermal using 1:2 with lines ls 1 title 'thermal', \
     data_rate_coupled using 1:2 with lines ls 2 title 'thermo-mechanical'
