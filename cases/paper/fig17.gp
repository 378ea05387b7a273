# Figure 17: Q solid, 2Q dashed, their means dotted.

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
set yrange [0:*]
since_then(t, value) = t < since ? NaN : value

@panel_a
eval heading('a', 'mean burn rate')
set ylabel 'mean r_{b}  / (cm/s)'
plot data_Q using 1:2 with lines ls 1 title 'Q_{g}', \
     '' using 1:(since_then($1, rate_Q)) with lines ls 11 title sprintf('mean %.3f cm/s', rate_Q), \
     data_2Q using 1:2 with lines ls 2 title '2 Q_{g}', \
     '' using 1:(since_then($1, rate_2Q)) with lines ls 12 title sprintf('mean %.3f cm/s', rate_2Q)

@panel_b
eval heading('b', 'largest strain norm')
set ylabel 'largest |E|'
plot data_Q using 1:3 with lines ls 1 title 'Q_{g}', \
     '' using 1:(since_then($1, strain_Q)) with lines ls 11 title sprintf('mean %.3f', strain_Q), \
     data_2Q using 1:3 with lines ls 2 title '2 Q_{g}', \
     '' using 1:(since_then($1, strain_2Q)) with lines ls 12 title sprintf('mean %.3f', strain_2Q)
