# Figure 3: solver as points (of a fine grid every second or fourth), exact solutions as lines; below each, how far they are
# from the exact one.

set xrange [0:150]
set lmargin at screen 0.15
set rmargin at screen 0.97

set style line 1 lt 1 pt 6 ps 0.6
set style line 2 lt 7 lw 1.4
set style line 3 lt 2 dt 2

# Some four tics of 1, 2 or 5 times a power of ten.
decade(span) = 10.0**floor(log10(span / 4))
tic(span) = decade(span) * (span > 20 * decade(span) ? 5 : span > 8 * decade(span) ? 2 : 1)

drawn = "\
stats data_small_strain using (times * column(difference_name)) name 'K' nooutput; \
stats solver using (times * column(difference_name)) name 'S' nooutput; \
sparse = S_records > 97 ? 4 : S_records > 48 ? 2 : 1; first = (S_records - 1) % sparse; \
set multiplot; \
set tmargin at screen 0.84; set bmargin at screen 0.44; set key on; \
set format x ''; unset xlabel; set ylabel symbol . unit; set ytics autofreq; \
plot data_exact using 'depth [um]':column_name with lines ls 2 title 'exact', \
     data_small_strain using 'depth [um]':column_name with lines ls 3 title 'Kuznetsov-Stewart', \
     solver every sparse::first using 'depth [um]':column_name with points ls 1 title 'solver'; \
set tmargin at screen 0.39; set bmargin at screen 0.15; unset key; unset label 100; unset label 101; \
set format x '%g'; set xlabel 'depth below the surface / µm'; set ylabel difference_label; \
set ytics tic((K_max > S_max ? K_max : S_max) - (K_min < S_min ? K_min : S_min)); \
plot data_exact using 'depth [um]':(0) with lines ls 2, \
     data_small_strain using 'depth [um]':(times * column(difference_name)) with lines ls 3, \
     solver every sparse::first using 'depth [um]':(times * column(difference_name)) with points ls 1; \
unset multiplot"

@panel_a
eval heading('a', 'temperature')
symbol = 'T'; unit = ' / K'; difference_label = 'T − exact / K'; times = 1
column_name = 'T [K]'; difference_name = 'T - exact [K]'; solver = data_nodes
@small_print
@drawn

@panel_b
eval heading('b', 'pressure')
symbol = 'p'; unit = ' / MPa'; difference_label = 'p − exact / MPa'; times = 1
column_name = 'p [MPa]'; difference_name = 'p - exact [MPa]'; solver = data_cells
@small_print
@drawn

@panel_c
eval heading('c', 'velocity of the solid')
symbol = 'v'; unit = ' / (µm/s)'; difference_label = 'v − exact / (µm/s)'; times = 1
column_name = 'v [um/s]'; difference_name = 'v - exact [um/s]'; solver = data_nodes
@small_print
@drawn

@panel_d
eval heading('d', 'deformation gradient')
symbol = 'F_{22}'; unit = ''; difference_label = '10^5 (F_{22}  − exact)'; times = 1e5
column_name = 'F22 [-]'; difference_name = 'F22 - exact [-]'; solver = data_cells
@small_print
@drawn
