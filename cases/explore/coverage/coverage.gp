# Coverage against width: one panel for three grids, one for four, made alike. Open points: the half that the default was
# chosen on; full ones: the other.

set border 3
set tmargin 6
set xlabel 'median half-width [true errors of the finest grid]'
set ylabel 'truths held [%]'
set logscale x
set format x '%g'
set xtics (1, 1.25, 1.5, 2, 3, 4, 5)
set xrange [1:5]
set yrange [60:102]
set offsets 0, 0, 0, 0
open(k) = k == 1 ? 6 : k == 2 ? 4 : k == 3 ? 8 : 12
full(k) = open(k) + 1

do for [m in 'three four'] {
    eval value('panel_' . m)
    eval small_print
    eval heading(m eq 'three' ? 'a' : 'b', 'every ' . m . ' grids of a series')
    points = value('data_' . m)
    last = int(value('last_' . m))
    plot 95 with lines dt 2 lc rgb grey title '95 %', \
        for [k = 1:last] points using ($1 == k && $2 == 1 ? $6 : NaN):3:4:5 with yerrorbars lt k pt open(k) ps 1.3 notitle, \
        for [k = 1:last] points using ($1 == k && $2 == 2 ? $6 * 1.01 : NaN):3:4:5 with yerrorbars lt k pt full(k) ps 1.3 title value(sprintf('estimate_%d', k))
}
