# Figure 14: the uppermost part of the pack.

set datafile missing '?'  # a NaN lifts the pen
set xrange [-width / 2:width / 2]
set yrange [bottom:top]
eval map_place(left_side, right_side, foot_side, head_side)

one_map = "\
set multiplot; \
@map_only; \
splot field using 1:2:column_number with pm3d; \
@map_frame; \
set xtics 40; set ytics 20; set xlabel 'x / µm'; set ylabel 'y / µm'; eval heading(letter, name); @small_print; \
plot data_rims using 1:2 with lines lw 1.0 lc rgb rim, data_surface using 1:2 with lines lw 1.0 lc rgb '#404040'; \
unset multiplot"

@panel_a
letter = 'a'; name = 'temperature'; field = data_nodes; column_number = 3; rim = 'white'
set cblabel 'T / K'
@viridis
set cbrange [lowest_temperature:largest_temperature]
@colours_nodes
@one_map

@panel_b
letter = 'b'; name = 'pressure'; field = data_cells; column_number = 3; rim = '#606060'
set cblabel 'p / MPa'
eval diverging(lowest_pressure, largest_pressure)
@colours_cells
@one_map

@panel_c
letter = 'c'; name = 'strain norm'; field = data_cells; column_number = 4; rim = 'white'
set cblabel '|E|'
@viridis
set cbrange [0:largest_strain]
@one_map
