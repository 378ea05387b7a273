# Means over packs with their confidence intervals, against one of the conditions (x_label, x_low, x_high).
# Tables curve_1 ... curve_<curves>: x, then mean and half-width of each quantity, with title_1 ...
# Points of one place are set `apart` a little, so that their bars can be told apart.

set key at screen 0.1, screen 0.26 left top vertical maxrows 4
set bmargin at screen 0.39
set tmargin 3
set offsets 0, 0, graph 0.05, graph 0.05
set xlabel x_label
set xrange [x_low:x_high]
curve(i) = value(sprintf('data_curve_%d', i))
title_of(i) = value(sprintf('title_%d', i))
means = "plot for [i = 1:curves] curve(i) using ($1 + apart * (i - 0.5 * (curves + 1))):mean:half \
with yerrorlines lt i title title_of(i) noenhanced"

@panel__V
eval heading('', 'regression rate V, mean over packs')
set ylabel 'V / (cm/s)'
mean = 2; half = 3
@means

@panel__rate
eval heading('', 'mean burn rate along the surface, mean over packs')
set ylabel 'mean burn rate / (cm/s)'
mean = 4; half = 5
@means

@panel__T
eval heading('', 'largest temperature, mean over packs')
set ylabel 'T / K'
mean = 6; half = 7
@means

if (has_strain) {
  @panel__strain
  eval heading('', 'largest strain within 5 µm of its maximum, mean over packs')
  set ylabel 'strain'
  mean = 8; half = 9
  @means
}
