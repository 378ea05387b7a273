# Figure 13 as a movie: temperature and strain side by side, in the laboratory.

set datafile missing '?'  # a NaN lifts the pen
set xrange [-width / 2:width / 2]
set yrange [bottom:0]
@viridis

@panel
do for [k = 1:frames] {
    set multiplot
    do for [side = 0:1] {
        at = left_side + side * pitch
        eval map_place(at, at + map_side, foot_side, head_side)
        @map_only
        table = side == 0 ? 'nodes' : 'cells'
        set cbrange [side == 0 ? lowest_temperature : 0:side == 0 ? largest_temperature : largest_strain]
        set cblabel ''  # it would stand nearer to the other map: each map has it above
        eval value(sprintf('colours_%s1', table))
        splot value(sprintf('data_%s%d', table, k)) using 1:2:3 + side with pm3d
        @map_frame
        set xtics -width / 4, width / 4, width / 4
        set ytics 100
        set title side == 0 ? 'temperature T / K' : 'strain norm |E|' offset 0, -0.6 noenhanced
        set xlabel 'x / µm'
        if (side == 0) {
            set ylabel 'y / µm'
            eval heading('', sprintf('t = %.0f ms', value(sprintf('time%d', k))))
            own_caption = caption . sprintf('  |  t = %.0f ms', value(sprintf('time%d', k)))
            set label 100 own_caption at screen 0.01, screen 0.025 left font ',9' textcolor rgb grey noenhanced
        } else {
            set ytics format ''
        }
        plot value(sprintf('data_rims%d', k)) using 1:2 with lines lw 1 lc rgb 'white', \
             value(sprintf('data_surface%d', k)) using 1:2 with lines lw 1 lc rgb '#404040'
        set ytics format '%g'
    }
    unset multiplot
}
