# Figure 16: the largest strain, the mean about it dashed, their means dotted.

@panel
eval heading('', 'largest strain norm')
set tmargin 5
set xlabel 't / ms'
set ylabel '|E|'
set xrange [0:until]
set yrange [0:*]
set key maxcols 2
since_then(t, value) = t < since ? NaN : value
plot data_largest using 1:2 with lines lt 1 lw 1.2 title 'largest on this grid', \
     '' using 1:(since_then($1, mean_largest)) with lines lt 1 lw 1.4 dt 3 title sprintf('its mean, %.3f', mean_largest), \
     data_about_peak using 1:2 with lines lt 2 lw 1.2 dt 2 title 'mean over 5 µm about it', \
     '' using 1:(since_then($1, mean_about_peak)) with lines lt 2 lw 1.4 dt 3 title sprintf('its mean, %.3f', mean_about_peak)
