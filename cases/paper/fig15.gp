# Figure 15: thermal solid, thermo-mechanical dashed, their means dotted. Below the temperatures is room to show again,
# larger, what comes after ignition.

set style line 1 lt 1 dt 1 lw 1.2
set style line 2 lt 2 dt 2 lw 1.2
set style line 11 lt 1 dt 3 lw 1.4
set style line 12 lt 2 dt 3 lw 1.4
set lmargin at screen 0.10
set rmargin at screen 0.98
set tmargin at screen 0.79
set bmargin at screen 0.19
set key maxcols 2
set xlabel 't / ms'
set xrange [0:until]
since_then(t, value) = t < since ? NaN : value

both = "\
plot data_thermal using 1:column_number with lines ls 1 title 'thermal', \
     '' using 1:(since_then($1, mean_thermal)) with lines ls 11 title sprintf(its_mean, mean_thermal), \
     data_coupled using 1:column_number with lines ls 2 title 'thermo-mechanical', \
     '' using 1:(since_then($1, mean_coupled)) with lines ls 12 title sprintf(its_mean, mean_coupled)"

@panel_a
eval heading('a', 'largest temperature')
set ylabel 'T / K'
set yrange [300:*]
column_number = 2
mean_thermal = temperature_thermal
mean_coupled = temperature_coupled
its_mean = 'mean %.1f K'
set multiplot
@both
stats data_thermal using (since_then($1, $2)) name 'A' nooutput
stats data_coupled using (since_then($1, $2)) name 'B' nooutput
unset label 100
unset label 101
unset key
unset xlabel
unset ylabel
set lmargin at screen 0.30
set rmargin at screen 0.96
set tmargin at screen 0.55
set bmargin at screen 0.28
set xrange [since:until]
set yrange [(A_min < B_min ? A_min : B_min) - 5:(A_max > B_max ? A_max : B_max) + 5]
set border 15
@both
unset multiplot

@panel_b
@small_print
eval heading('b', 'mean burn rate')
set border 3
set key on
set lmargin at screen 0.10
set rmargin at screen 0.98
set tmargin at screen 0.79
set bmargin at screen 0.19
set xlabel 't / ms'
set ylabel 'mean r_{b}  / (cm/s)'
set xrange [0:until]
set yrange [0:*]
column_number = 3
mean_thermal = rate_thermal
mean_coupled = rate_coupled
its_mean = 'mean %.3f cm/s'
@both
