# Figure 4: near the surface. Points are the solver's, lines exact.

set xlabel 'depth below the surface / µm'
set ylabel 'T / K'
set style line 1 lt 7 pt 6 ps 0.7 lw 1.2
set style line 2 lt 1 pt 6 ps 0.7 lw 1.2
set style line 3 lt 2 pt 6 ps 0.7 lw 1.2

@panel_a
set title 'a   AP, 200 cal/(s cm^2)'
set xrange [0:8]
plot data_AP_thermal using 'depth [um]':'exact T [K]' with lines ls 1 title 'thermal', '' using 'depth [um]':'T [K]' with points ls 1 notitle, \
     data_AP_alpha using 'depth [um]':'exact T [K]' with lines ls 2 title 'β = α K', '' using 'depth [um]':'T [K]' with points ls 2 notitle, \
     data_AP_three_alpha using 'depth [um]':'exact T [K]' with lines ls 3 title 'β = 3 α K', '' using 'depth [um]':'T [K]' with points ls 3 notitle

@panel_b
set title 'b   binder, 100 cal/(s cm^2)'
set xrange [0:60]
plot data_binder_thermal using 'depth [um]':'exact T [K]' with lines ls 1 title 'thermal', '' using 'depth [um]':'T [K]' with points ls 1 notitle, \
     data_binder_alpha using 'depth [um]':'exact T [K]' with lines ls 2 title 'β = α K', '' using 'depth [um]':'T [K]' with points ls 2 notitle, \
     data_binder_three_alpha using 'depth [um]':'exact T [K]' with lines ls 3 title 'β = 3 α K', '' using 'depth [um]':'T [K]' with points ls 3 notitle
