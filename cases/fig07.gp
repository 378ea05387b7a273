# Figure 7: maps of the upper part of the sandwich. The dashed lines are the interfaces.

@map_axes
set xlabel 'x / µm'
set ylabel 'y / µm'
set xrange [-120:120]
set yrange [top - 240:top + 5]
set arrow 1 from -strip / 2, graph 0 to -strip / 2, graph 1 nohead front dt 3 lw 0.8 lc rgb 'white'
set arrow 2 from strip / 2, graph 0 to strip / 2, graph 1 nohead front dt 3 lw 0.8 lc rgb 'white'

@panel_a
set title 'a   temperature'
set cblabel 'T / K'
@viridis
@colours_T
splot data_T using 1:2:3 with pm3d

@panel_b
set title 'b   pressure'
set cblabel 'p / MPa'
@diverging
set arrow 1 lc rgb 'grey40'
set arrow 2 lc rgb 'grey40'
most = largest_pressure
@symmetric
@colours_p
splot data_p using 1:2:3 with pm3d

@panel_c
set title 'c   strain norm'
set cblabel '|E|'
@viridis
set arrow 1 lc rgb 'white'
set arrow 2 lc rgb 'white'
set autoscale cb
@colours_strain
splot data_strain using 1:2:3 with pm3d
