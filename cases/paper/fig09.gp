# Figure 9: filled points, distance to the finest grid (the paper's way); open points, to the next finer grid.
# In the table columns 2, 4, ... are the former, 3, 5, ... the latter.

@loglog
set xlabel 'Δx / µm'
set lmargin at screen 0.12
set rmargin at screen 0.66
set tmargin at screen 0.90
set key outside right top vertical Left reverse samplen 2 spacing 1.3
set key title "order to the finest grid\n(paper's way) | to the next" left
symbols = 'σ_{11} σ_{22} σ_{33} τ u v ξ_1 ξ_2'
order(set, k) = word(symbols, k) . gprintf('   %.2f', value(sprintf('papers_%s_%d', set, k))) . \
                gprintf(' | %.2f', value(sprintf('unbiased_%s_%d', set, k)))
array filled[4] = [7, 5, 9, 13]
array open[4] = [6, 4, 8, 12]

# A tic for each grid. The slope stands above the largest error, between the two coarsest grids.
stats data_sandwich using 1 name 'H' nooutput
set xrange [H_min / 1.2:H_max * 1.2]
set samples 1000
set xtics ()
do for [k = 0:H_records - 1] { eval sprintf("set xtics add ('%.4g' %g)", H_max / 2**k, H_max / 2**k) }
first(x) = x < H_max / 2 || x > H_max ? NaN : top * x / H_max

do for [panel in 'a b c d e f'] {
    field = strstrt('abcdef', panel) - 1
    set_name = field < 3 ? 'sandwich' : 'mean'
    front = field < 3 ? 'each side burns as itself' : 'the mean of both rates between materials'
    field = field % 3
    from = field == 0 ? 1 : field == 1 ? 5 : 7
    to = field == 0 ? 4 : from + 1
    what = word('stress velocity map', field + 1)
    eval value('panel_' . panel)
    eval heading(panel, what . ': ' . front)
    set ylabel 'root mean square difference / ' . word('MPa (µm/s) µm', field + 1)
    set yrange [*:*]
    data = value('data_' . set_name)
    top = 0
    least = 1e300
    do for [c = 2 * from:2 * to + 1] {
        stats data using c name 'E' nooutput
        top = E_max > top ? E_max : top
        least = E_min < least ? E_min : least
    }
    set yrange [least / 2:4 * top]
    top = 1.7 * top
    plot for [k = from:to] data using 1:2 * k with linespoints lt k - from + 1 pt filled[k - from + 1] title order(set_name, k), \
         for [k = from:to] data using 1:2 * k + 1 with linespoints lt k - from + 1 dt 3 lw 1.2 pt open[k - from + 1] notitle, \
         first(x) with lines lc rgb grey lw 1 dt 2 title 'order 1', \
         NaN with linespoints lc rgb 'black' pt 7 title 'to the finest grid', \
         NaN with linespoints lc rgb 'black' dt 3 lw 1.2 pt 6 title 'to the next finer'
}
