# Figure 5: left the window and what acts on it, one scale for x and y; right its surface, stretched. AP is grey, binder
# yellow; the present solid is filled.

set style line 1 lc rgb '#303030' lw 1.6 dt 3
set style line 2 lc rgb '#d55e00' lw 2.6 dt 1
set style line 3 lc rgb '#606060' lw 1.0 dt 1
set style line 4 lc rgb '#0072b2' lw 1.4 dt 1
set style line 5 lc rgb '#d55e00' lw 1.4 dt 1
half = width / 2
stats data_surface using 2 name 'S' nooutput

@panel
set multiplot
set size ratio -1
unset offsets
unset grid
set xlabel 'x / µm'
set ylabel 'y / µm'
set lmargin at screen 0.08
set rmargin at screen 0.50
set tmargin at screen 0.92
set bmargin at screen 0.11
set xrange [-half - 90:half + 90]
set yrange [axis_height - depth - 80:70]
set xtics ()
do for [x in sprintf('%g %g %g %g', -half, -strip / 2, strip / 2, half)] { set xtics add (gprintf('%g', x + 0) x + 0) }
set ytics half
set key at graph 0.5, graph 1.0 center bottom horizontal maxcols 2

set arrow 1 from -half, 0 to half, 0 nohead ls 1 front
set arrow 2 from -half, -depth to half, -depth nohead ls 1 front
set arrow 3 from -half, 0 to -half, -depth nohead ls 1 front
set arrow 4 from half, 0 to half, -depth nohead ls 1 front

middle = S_max - depth / 2
set label 1 'AP' at -half / 2 - strip / 4, middle center front
set label 2 'binder' at 0, middle center rotate by 90 front
set label 3 'AP' at half / 2 + strip / 4, middle center front

# Loads: heat (vermilion) and pressure (blue) act on the whole surface.
tag = 10
do for [k = -5:5] {
    x = k * half / 5.5
    set arrow tag from x, S_max + 52 to x, S_max + 12 size 7, 22 filled front ls (k % 2 == 0 ? 4 : 5)
    tag = tag + 1
}
set label 4 sprintf('σ·n = −p_c n,  p_c = %g MPa', pressure) at 0, S_max + 70 center front tc rgb '#0072b2'
set label 5 sprintf('Q_g = %g (AP), %g (binder) cal/(s cm^2)', flux_AP, flux_binder) at 0, 25 center front tc rgb '#d55e00'
set label 7 'periodic' at -half - 16, middle center rotate by 90 front
set label 8 'periodic' at half + 16, middle center rotate by 90 front
set label 9 sprintf('T = %g K,  v = 0,  u free but for one pinned node', bottom_temperature) at 0, axis_height - depth - 50 center front
set object 1 circle at 0, axis_height - depth size 6 front fc rgb 'black' fs solid

plot data_surface using 1:2:(column(2) - depth) with filledcurves fc rgb '#dddddd' notitle, \
     '' using (abs(column(1)) <= strip / 2 + 1e-6 ? column(1) : NaN):2:(column(2) - depth) with filledcurves fc rgb '#f5e3b0' notitle, \
     '' using 1:(column(2) - depth) with lines ls 3 notitle, \
     '' using 1:2 with lines ls 2 title sprintf('surface at t = %g ms', time), \
     NaN with lines ls 1 title 'window at t = 0'

# The present surface by itself.
unset arrow
unset object
do for [l in '1 2 3 4 5 7 8 9 100'] { unset label l + 0 }
set size noratio
set lmargin at screen 0.62
set rmargin at screen 0.97
set tmargin at screen 0.92
set bmargin at screen 0.52
set xrange [-half:half]
set ytics autofreq
set grid
span = S_max - S_min
set yrange [S_min - 0.15 * span:S_max + 0.25 * span]
set key at graph 0, graph 1.02 left bottom
set label 1 'AP' at -half / 2 - strip / 4, S_max center
set label 2 'binder' at 0, S_max + 0.12 * span center
set label 3 'AP' at half / 2 + strip / 4, S_max center
set arrow 1 from -strip / 2, graph 0 to -strip / 2, graph 1 nohead ls 1
set arrow 2 from strip / 2, graph 0 to strip / 2, graph 1 nohead ls 1
plot data_surface using 1:2 with lines ls 2 title 'the same surface, stretched'
unset multiplot
