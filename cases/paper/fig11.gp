# Figure 11: thermal solid, thermo-mechanical dashed. No title: there is one panel.

@panel
set xlabel 'x from the edge / µm'
set ylabel 'height above the edge / µm'
set xrange [0:*]
set xtics 40
set tmargin 3
plot data_thermal using 1:2 with lines lt 1 dt 1 title 'thermal', \
     data_coupled using 1:2 with lines lt 2 dt 2 title 'thermo-mechanical'
