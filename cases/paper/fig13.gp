# Figure 13: four maps side by side, all in the laboratory. Their places are fractions of the panel.

set datafile missing '?'  # a NaN lifts the pen
set xrange [-width / 2:width / 2]
set yrange [bottom:5]

# What stands on all four is drawn with the first only.
four_maps = "\
set multiplot; \
do for [k = 1:4] { \
    eval map_place(left_side + (k - 1) * map_side, left_side + k * map_side - gap_side, foot_side, foot_side + map_height); \
    @map_only; \
    if (k == 4) { set colorbox } else { unset colorbox }; \
    splot value(sprintf('data_%s%d', table, k)) using 1:2:column_number with pm3d; \
    @map_frame; \
    set xtics -width / 4, width / 4, width / 4; set ytics 100; set xlabel 'x / µm'; set title value(sprintf('time%d', k)) offset 0,-0.4; \
    if (k == 1) { set ylabel 'y / µm'; set ytics format '%g'; eval heading(letter, name); @small_print } \
    else { unset ylabel; set ytics format '' }; \
    plot value(sprintf('data_rims%d', k)) using 1:2 with lines lw 0.7 lc rgb rim, \
         value(sprintf('data_surface%d', k)) using 1:2 with lines lw 0.8 lc rgb '#404040' \
}; \
unset multiplot"

@panel_a
letter = 'a'; name = 'temperature'; table = 'nodes'; column_number = 3; rim = 'white'
set cblabel 'T / K'
@viridis
set cbrange [lowest_temperature:largest_temperature]
@colours_nodes1
@four_maps

@panel_b
letter = 'b'; name = 'pressure'; table = 'cells'; column_number = 3; rim = '#606060'
set cblabel 'p / MPa'
eval diverging(lowest_pressure, largest_pressure)
@colours_cells1
@four_maps

@panel_c
letter = 'c'; name = 'strain norm'; table = 'cells'; column_number = 4; rim = 'white'
set cblabel '|E|'
@viridis
set cbrange [0:largest_strain]
@four_maps
