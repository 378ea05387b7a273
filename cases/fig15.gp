# Figure 15: thermal solid, thermo-mechanical dashed, their means dotted.

set style line 1 lt 1 dt 1 lw 1.2
set style line 2 lt 2 dt 2 lw 1.2
set style line 11 lt 1 dt 3 lw 1.2
set style line 12 lt 2 dt 3 lw 1.2
set xlabel 't / ms'
set xrange [0:until]
since_then(t, value) = t < since ? NaN : value

@panel_a
set title 'a   largest temperature'
set ylabel 'T / K'
plot data_thermal using 1:2 with lines ls 1 title 'thermal', \
     '' using 1:(since_then($1, temperature_thermal)) with lines ls 11 title sprintf('%.1f K', temperature_thermal), \
     data_coupled using 1:2 with lines ls 2 title 'thermo-mechanical', \
     '' using 1:(since_then($1, temperature_coupled)) with lines ls 12 title sprintf('%.1f K', temperature_coupled)

@panel_b
set title 'b   mean burn rate'
set ylabel 'mean r_{b} / (cm/s)'
set yrange [0:*]
plot data_thermal using 1:3 with lines ls 1 title 'thermal', \
     '' using 1:(since_then($1, rate_thermal)) with lines ls 11 title sprintf('%.3f cm/s', rate_thermal), \
     data_coupled using 1:3 with lines ls 2 title 'thermo-mechanical', \
     '' using 1:(since_then($1, rate_coupled)) with lines ls 12 title sprintf('%.3f cm/s', rate_coupled)
