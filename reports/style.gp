# The look of every figure. Loaded before the script of a figure; needs no variable but `caption`.

set encoding utf8
set datafile separator ','
set datafile columnheaders
set datafile missing NaN

# Lines: Okabe and Ito's colours, told apart by colour-blind readers; points and dashes differ too, for print in grey.
set linetype 1 lc rgb '#0072b2' lw 1.8 pt 7  ps 0.6 dt 1
set linetype 2 lc rgb '#d55e00' lw 1.8 pt 5  ps 0.6 dt 1
set linetype 3 lc rgb '#009e73' lw 1.8 pt 9  ps 0.8 dt 1
set linetype 4 lc rgb '#cc79a7' lw 1.8 pt 13 ps 0.8 dt 1
set linetype 5 lc rgb '#e69f00' lw 1.8 pt 11 ps 0.8 dt 1
set linetype 6 lc rgb '#56b4e9' lw 1.8 pt 4  ps 0.7 dt 1
set linetype 7 lc rgb '#000000' lw 1.8 pt 6  ps 0.7 dt 1
set linetype 8 lc rgb '#999999' lw 1.8 pt 8  ps 0.7 dt 1
set linetype cycle 8
grey = '#606060'

set border 3 lw 0.8 lc rgb grey
set tics nomirror out scale 0.6 textcolor rgb 'black'
set grid lc rgb '#dddddd' lw 0.6 dt 1
# Above the plot, where no curve can pass.
set tmargin 4
set key at graph 0, graph 1.02 left bottom horizontal Left reverse samplen 2 spacing 1.2 width 1
set minussign
set offsets 0, 0, graph 0.03, 0  # no curve along the upper edge
set bmargin 5

# Small print at the foot: grid, step, revision. Where several plots make a panel, it and the heading belong to one:
# @no_texts before the others, @small_print before the next panel.
# As large as it fits: of 10 points some 105 letters do in a panel of the usual width.
small_print = "set label 100 caption at screen 0.01, screen 0.025 left font (strlen(caption) > 105 ? ',8' : ',10') \
textcolor rgb grey noenhanced"
no_texts = "unset label 100; unset label 101"
@small_print

# `eval heading('a', 'temperature')`: letter and title of a panel, in its upper left corner.
heading(letter, title) = sprintf('set label 101 "%s%s" at graph 0, screen 1 left offset 0, character -1.5', \
    letter eq '' ? '' : '{/:Bold ' . letter . '}   ', title)

# Maps, in @viridis or `eval diverging(...)`: `eval map_place(left, right, bottom, top)` says where in the panel, in fractions
# of it and in the proportions of the ranges, then within a multiplot
#     @map_only
#     @colours_<table>
#     splot data_<table> using 1:2:3 with pm3d
#     @map_frame
#     plot ...     the lines on it, with tics and labels
viridis = "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4a89', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', \
6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')"
# Red above zero and blue below, white at zero: `eval diverging(low, high)`, equally strong for equal sizes. Where little is
# below zero, the colour bar ends soon below it.
blue = "-5 '#053061', -4 '#2166ac', -3 '#4393c3', -2 '#92c5de', -1 '#d1e5f0', "
blues(n) = n > 0 ? blue[strstrt(blue, sprintf('-%d', n)):] : ''
steps(low, high) = ceil(5 * (low < 0 ? -low : 0) / (-low > high ? -low : high))
diverging(low, high) = sprintf("set palette defined (%s0 '#f7f7f7', 1 '#fddbc7', 2 '#f4a582', 3 '#d6604d', 4 '#b2182b', 5 '#67001f'); \
set cbrange [%.9g:%.9g]", blues(steps(low, high)), \
-0.2 * steps(low, high) * (-low > high ? -low : high), -low > high ? -low : high)
map_place(left, right, bottom, top) = sprintf("unset offsets; unset key; unset grid; set cblabel offset 1,0; \
set lmargin at screen %.9g; set rmargin at screen %.9g; set bmargin at screen %.9g; set tmargin at screen %.9g", \
left, right, bottom, top)
map_only = "set view map; unset border; unset xtics; unset ytics; unset ztics; unset xlabel; unset ylabel; unset arrow; unset title; unset label 100; \
unset label 101"
map_frame = "set border 15; set xtics out nomirror scale 0.6 textcolor rgb 'black'; \
set ytics out nomirror scale 0.6 textcolor rgb 'black'"
@viridis

# Orders: @loglog for errors against cell size, which is halved from grid to grid.
loglog = "unset offsets; set logscale x 2; set logscale y 10; set format x '%.2g'; set format y '10^{%T}'; set mytics 10; \
set grid xtics ytics mytics"
