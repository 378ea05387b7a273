# Extremes: one panel a map, all made alike. Marks by standing: 0 right, 1 remarked, 2 refused, 3 wrong, 4 refused though right.

mark(k) = k == 0 ? 7 : k == 1 ? 9 : k == 2 ? 2 : k == 3 ? 15 : 10
colour(k) = k == 0 ? 0x0072b2 : k == 1 ? 0xe69f00 : k == 2 ? 0x606060 : k == 3 ? 0xd50032 : 0x009e73
standing(k) = k == 0 ? 'right' : k == 1 ? 'remarked' : k == 2 ? 'refused' : k == 3 ? 'wrong without a word' : 'refused, yet right'
line_colour(k) = word('#000000 #cc79a7 #009e73', k)

unset offsets
set border 15
set grid noxtics noytics
set tmargin 7
set bmargin 7
# Over the whole width: beside long names the plot itself is narrow.
set key noenhanced at screen 0.98, screen 0.91 right top vertical maxrows 3 samplen 2
set rmargin 3

do for [m in maps] {
    eval value('panel_' . m)
    eval small_print
    eval heading(m, value('title_' . m))
    set label 102 value('agree_' . m) at screen 0.01, screen 0.075 left font ',10' noenhanced
    set xlabel value('xlabel_' . m)
    set ylabel value('ylabel_' . m)
    unset logscale
    set format '%g'
    if (value('xlog_' . m)) { set logscale x }
    if (value('ylog_' . m)) { set logscale y }
    set xtics autofreq
    set ytics autofreq
    if (value('xtics_' . m) ne '') { eval 'set xtics (' . value('xtics_' . m) . ')' }
    if (value('ytics_' . m) ne '') { eval 'set ytics (' . value('ytics_' . m) . ')' }
    set xrange [value('xfrom_' . m):value('xto_' . m)]
    set yrange [value('yfrom_' . m):value('yto_' . m)]
    limits = int(value('limits_' . m))
    points = value('data_points_' . m)
    limit_data(k) = value(sprintf('data_limit_%s_%d', m, k))
    limit_title(k) = value(sprintf('limit_%s_%d', m, k))
    command = ''
    do for [k = 1:limits] {
        command = command . sprintf("'%s' using 1:2:($3-$1):($4-$2) with vectors nohead lw 2 lc rgb '%s' notitle, keyentry with lines lw 2 lc rgb '%s' title '%s', ", \
            limit_data(k), line_colour(k), line_colour(k), limit_title(k))
    }
    eval 'plot ' . command . "points using 1:2:(mark($3)):(colour($3)) with points pt variable lc rgb variable ps 1.2 notitle, for [k in '0 1 2 4 3'] keyentry with points pt mark(k + 0) lc rgb colour(k + 0) ps 1.2 title standing(k + 0)"
}
