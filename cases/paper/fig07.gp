# Figure 7: maps of the upper part of the sandwich. Dashed lines are the interfaces.

set xrange [-width / 2:width / 2]
set yrange [bottom:top]
eval map_place(left_side, right_side, foot_side, head_side)
half = strip / 2

one_map = "\
set multiplot; \
@map_only; \
splot field using 1:2:3 with pm3d; \
@map_frame; \
set arrow 1 from -half, bottom to -half, top nohead front dt 2 lw 0.8 lc rgb side; \
set arrow 2 from half, bottom to half, top nohead front dt 2 lw 0.8 lc rgb side; \
set xtics (-width / 2, -half, half, width / 2); set ytics 50; set xlabel 'x / µm'; set ylabel 'y / µm'; \
eval heading(letter, name); @small_print; \
plot data_surface using 1:2 with lines lw 1.0 lc rgb '#404040'; \
unset multiplot"

@panel_a
letter = 'a'; name = 'temperature'; field = data_T; side = 'white'
set cblabel 'T / K'
@viridis
set autoscale cbfix
@colours_T
@one_map

@panel_b
letter = 'b'; name = 'pressure'; field = data_p; side = '#606060'
set cblabel 'p / MPa'
eval diverging(lowest_pressure, largest_pressure)
@colours_p
@one_map

@panel_c
letter = 'c'; name = 'strain norm'; field = data_strain; side = 'white'
set cblabel '|E|'
@viridis
set autoscale cbfix
set cbrange [0:*]
@colours_strain
@one_map
