# Figure 8: one line for each number of columns, the finest solid.

set xlabel 'x / µm'
set autoscale xfix
set xtics 40
n = words(grids)
line_of(k) = value('data_nx' . word(grids, k))

do for [k = 1:n] {
    dash = k == n ? 1 : n + 1 - k
    set style line k lt k dt dash
}

@panel_a
eval heading('a', 'surface temperature')
set ylabel 'T_{s}  / K'
plot for [k = 1:n] line_of(k) using 1:2 with lines ls k title word(grids, k) . ' columns'

@panel_b
eval heading('b', 'surface profile')
set ylabel 'height above the edge / µm'
plot for [k = 1:n] line_of(k) using 1:3 with lines ls k title word(grids, k) . ' columns'
