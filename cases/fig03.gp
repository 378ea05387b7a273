# Figure 3: solver as points, exact solutions as lines.

set xlabel 'depth below the surface / µm'
set xrange [0:150]

set style line 1 lt 1 pt 6 ps 0.6
set style line 2 lt 7 lw 1.4
set style line 3 lt 2 dt 2

@panel_a
set title 'a   temperature'
set ylabel 'T / K'
plot data_exact using 'depth [um]':'T [K]' with lines ls 2 title 'exact', \
     data_small_strain using 'depth [um]':'T [K]' with lines ls 3 title 'Kuznetsov-Stewart', \
     data_nodes using 'depth [um]':'T [K]' with points ls 1 title 'solver'

@panel_b
set title 'b   pressure'
set ylabel 'p / MPa'
plot data_exact using 'depth [um]':'p [MPa]' with lines ls 2 title 'exact', \
     data_small_strain using 'depth [um]':'p [MPa]' with lines ls 3 title 'Kuznetsov-Stewart', \
     data_cells using 'depth [um]':'p [MPa]' with points ls 1 title 'solver'

@panel_c
set title 'c   velocity of the solid'
set ylabel 'v / (µm/s)'
plot data_exact using 'depth [um]':'v [um/s]' with lines ls 2 title 'exact', \
     data_small_strain using 'depth [um]':'v [um/s]' with lines ls 3 title 'Kuznetsov-Stewart', \
     data_nodes using 'depth [um]':'v [um/s]' with points ls 1 title 'solver'

@panel_d
set title 'd   deformation gradient'
set ylabel 'F_{22}'
plot data_exact using 'depth [um]':'F22 [-]' with lines ls 2 title 'exact', \
     data_small_strain using 'depth [um]':'F22 [-]' with lines ls 3 title 'Kuznetsov-Stewart', \
     data_cells using 'depth [um]':'F22 [-]' with points ls 1 title 'solver'
