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
set key outside right top vertical Left reverse samplen 2 spacing 1.2 width 1
set bmargin 5

# Small print at the foot: grid, step, revision.
set label 100 caption at screen 0.01, screen 0.025 left font ',7' textcolor rgb grey noenhanced

# Maps: @map_axes once, then `@colours_<table>` and `splot data_<table> using 1:2:3 with pm3d`.
# @viridis for sizes, @diverging where sign matters (with a cbrange symmetric about zero: @symmetric after `most = ...`).
viridis = "set palette defined (0 '#440154', 1 '#482878', 2 '#3e4a89', 3 '#31688e', 4 '#26828e', 5 '#1f9e89', \
6 '#35b779', 7 '#6ece58', 8 '#b5de2b', 9 '#fde725')"
diverging = "set palette defined (0 '#053061', 1 '#2166ac', 2 '#4393c3', 3 '#92c5de', 4 '#d1e5f0', 5 '#f7f7f7', \
6 '#fddbc7', 7 '#f4a582', 8 '#d6604d', 9 '#b2182b', 10 '#67001f')"
symmetric = "set cbrange [-most:most]"
map_axes = "set view map; unset key; unset grid; set border 15; set size ratio -1; \
set lmargin at screen 0.17; set rmargin at screen 0.78; set bmargin at screen 0.14; set tmargin at screen 0.93; \
set xtics out offset 0,1.2; set ytics out; set xlabel offset 0,1.4; set title offset 0,-0.4; \
set autoscale xfix; set autoscale yfix; set autoscale cbfix; set colorbox"
@viridis

# Orders: @loglog for errors against cell size, which is halved from grid to grid.
loglog = "set logscale x 2; set logscale y 10; set format x '%.2g'; set format y '10^{%T}'; set mytics 10; \
set grid xtics ytics mytics"
