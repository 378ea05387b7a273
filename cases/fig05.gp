# Figure 5: y over x, one scale for both. AP is grey, binder is yellow; the present solid is filled.

@panel_a
set title 'a   window and conditions'
set size ratio -1
set xlabel 'x / µm'
set ylabel 'y / µm'
set lmargin at screen 0.16
set rmargin at screen 0.90
set tmargin at screen 0.95
set bmargin at screen 0.12
half = width / 2
set xrange [-half - 150:half + 150]
set yrange [-depth - 220:150]
set xtics ('-120' -half, '-30' -strip / 2, '30' strip / 2, '120' half)
set ytics 120
unset grid
set key at graph 0.99, graph 0.99 right top Left reverse samplen 2 spacing 1.2 opaque

stats data_surface using 2 name 'S' nooutput
edge = S_max
set style line 1 lc rgb '#303030' lw 1.6 dt 3
set style line 2 lc rgb '#d55e00' lw 2.6
set style line 3 lc rgb '#606060' lw 1.0
set style line 4 lc rgb '#0072b2' lw 1.4
set style line 5 lc rgb '#d55e00' lw 1.4

# The solid's sides, and its initial window.
set arrow 1 from -half, 0 to half, 0 nohead ls 1 front
set arrow 2 from -half, -depth to half, -depth nohead ls 1 front
set arrow 3 from -half, 0 to -half, -depth nohead ls 1 front
set arrow 4 from half, 0 to half, -depth nohead ls 1 front

set label 1 'AP' at -75, -330 center front
set label 2 'binder' at 0, -330 center rotate by 90 front
set label 3 'AP' at 75, -330 center front

# Loads: the flux (vermilion) comes down with the pressure (blue).
tag = 10
do for [k = -5:5] {
    x = 22.0 * k
    set arrow tag from x, edge + 62 to x, edge + 22 size 7, 22 filled front ls (k % 2 == 0 ? 4 : 5)
    tag = tag + 1
}
set label 4 sprintf('σ·n = −p_c n,  p_c = %g MPa', pressure) at 0, edge + 82 center front tc rgb '#0072b2'
set label 5 sprintf('Q_g = %g (AP), %g (binder) cal/(s cm^2)', flux_AP, flux_binder) at 0, 25 center front tc rgb '#d55e00'
set label 7 'periodic' at -half - 14, -330 center rotate by 90 front
set label 8 'periodic' at half + 14, -330 center rotate by 90 front
set label 9 sprintf('T = %g K,  v = 0,  u free but for one pinned node', bottom_temperature) at 0, axis_height - depth - 45 center front
set object 1 circle at 0, axis_height - depth size 6 front fc rgb 'black' fs solid

plot data_surface using 1:2:(column(2) - depth) with filledcurves fc rgb '#dddddd' notitle, \
     '' using (abs(column(1)) <= strip / 2 + 1e-6 ? column(1) : NaN):2:(column(2) - depth) with filledcurves fc rgb '#f5e3b0' notitle, \
     '' using 1:(column(2) - depth) with lines ls 3 notitle, \
     '' using 1:2 with lines ls 2 title sprintf('surface after %g ms', time), \
     NaN with lines ls 1 title 'at the start'

# The present surface by itself, with what acts on it.
@panel_b
unset arrow
unset object
do for [l in '1 2 3 4 5 7 8 9'] { unset label l }
set title sprintf('b   surface after %g ms', time)
set size noratio
unset lmargin
unset rmargin
unset tmargin
set bmargin 5
set key outside right top
set xrange [-half:half]
set xtics 40
set ytics autofreq
set grid
stats data_surface using 2 name 'S' nooutput
span = S_max - S_min
set yrange [S_min - 0.15 * span:S_max + 0.15 * span]
set arrow 1 from -strip / 2, graph 0 to -strip / 2, graph 1 nohead ls 1
set arrow 2 from strip / 2, graph 0 to strip / 2, graph 1 nohead ls 1
plot data_surface using 1:2 with lines ls 2 title 'surface', \
     NaN with lines ls 1 title 'AP | binder'
