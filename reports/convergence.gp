# Errors against cell size, with the slopes they are expected to follow.
# Tables curve_1 ... curve_<curves> (h, error) with title_1 ..., and slope_1 ... slope_<slopes> with slope_title_1 ...

@panel
@loglog
set title heading noenhanced
set tmargin 3
set key outside right top vertical  # names are long
set xlabel h_label noenhanced
set ylabel error_label noenhanced
set autoscale xfix
set autoscale yfix
set offsets graph 0.04, graph 0.04, graph 0.05, graph 0.05
curves_of(i) = value(sprintf('data_curve_%d', i))
title_of(i) = value(sprintf('title_%d', i))
if (slopes == 0) {
  plot for [i = 1:curves] curves_of(i) using 1:2 with linespoints lt i title title_of(i) noenhanced
} else {
  plot for [i = 1:slopes] value(sprintf('data_slope_%d', i)) using 1:2 with lines lc rgb grey lw 1 dt i + 1 \
           title value(sprintf('slope_title_%d', i)), \
       for [i = 1:curves] curves_of(i) using 1:2 with linespoints lt i title title_of(i) noenhanced
}
