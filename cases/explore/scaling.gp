# Scaling: seconds and memory against unknowns, iterations against contrasts.

set logscale xy 10
set format x '10^{%T}'
set format y '%g'
set grid xtics ytics
set tmargin 4
set bmargin 5
set key left top vertical maxcols 1
unset offsets

@panel_a
eval heading('a', 'CPU time of a step')
set xlabel 'unknowns'
set ylabel 'CPU time / s'
set xrange [3e3:2e6]
plot data_cholmod using 1:2 with linespoints lt 1 pt 7 title sprintf('CHOLMOD, unknowns^{%.2f}', exponent_cholmod), \
     data_pcg using 1:2 with linespoints lt 2 pt 4 title sprintf('Jacobi-PCG at 1e-8, unknowns^{%.2f}', exponent_pcg)

@panel_b
eval heading('b', 'largest memory')
set ylabel 'memory / MB'
plot data_cholmod using 1:3 with linespoints lt 1 pt 7 title 'CHOLMOD', \
     data_pcg using 1:3 with linespoints lt 2 pt 4 title 'Jacobi-PCG'

@panel_c
eval heading('c', sprintf('iterations of Jacobi-PCG, %.0f x %.0f cells', columns, 2 * columns))
set xlabel 'shear moduli apart, or K/μ'
set ylabel 'iterations of a step'
set xrange [1:1e8]
plot data_shear using 1:4 with linespoints lt 1 pt 7 title 'shear moduli of strip and sides apart', \
     data_bulk using 1:4 with linespoints lt 2 pt 4 title 'K/μ of both'
