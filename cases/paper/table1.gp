# Table 1 as a picture: a row of the table a row of text, what differs from the print in vermilion.

@panel
unset border
unset tics
unset grid
unset key
set lmargin at screen 0.02
set rmargin at screen 0.98
set tmargin at screen 0.97
set bmargin at screen 0.07
set xrange [0:100]
rows = properties_rows + consequences_rows
set yrange [-rows - 2.7:1.6]

# The last column of a row: how far apart print and use may be; wide for orders of magnitude, 0 where nothing is printed.
# A NaN must not be looked at: gnuplot leaves out a point for it.
# Powers of ten where they read better; no exponent below 1e6.
power(v) = gprintf('%.1t', v) eq '1.0' ? gprintf('10^{%T}', v) : gprintf('%.1t×10^{%T}', v)
plain(v) = abs(v) >= 1e5 ? gprintf('%.0f', v) : gprintf('%.5g', v)
number(v) = abs(v) < 1e-2 || abs(v) >= 1e6 ? power(v) : plain(v)
printed(v, factor) = factor > 2 ? '≈ ' . number(v) : number(v)
same(ratio, factor) = ratio > 1 / factor && ratio < factor
colour(v, p, factor) = same(v / p, factor) ? 0x000000 : 0xd55e00
name(block, k) = value(sprintf('%s_%d', block, int(k)))
unit(block, k) = value(sprintf('%s_unit_%d', block, int(k)))

set label 1 '{/:Bold property' at 1, 0.6 left
set label 2 '{/:Bold unit' at 38, 0.6 left
set label 3 '{/:Bold AP, used' at 61, 0.6 right
set label 4 '{/:Bold printed' at 73, 0.6 right
set label 5 '{/:Bold binder, used' at 87, 0.6 right
set label 6 '{/:Bold printed' at 99, 0.6 right
set arrow 1 from 0, 1.3 to 100, 1.3 nohead lw 1.6
set arrow 2 from 0, 0.0 to 100, 0.0 nohead lw 0.8
set arrow 3 from 0, -properties_rows - 0.3 to 100, -properties_rows - 0.3 nohead lw 0.8
set arrow 4 from 0, -rows - 1.9 to 100, -rows - 1.9 nohead lw 1.6
set label 8 'Vermilion: not as printed, or not printed.' at 1, -rows - 2.4 left font ',9' tc rgb '#d55e00'
set label 7 'what follows' at 1, -properties_rows - 1.0 left font ',11:Italic'

place(block, k) = block eq 'properties' ? -k + 0.3 : -properties_rows - k - 1.1
plot for [block in 'properties consequences'] value('data_' . block) \
         using (1):(place(block, column(1))):(name(block, column(1))) with labels left notitle, \
     for [block in 'properties consequences'] value('data_' . block) \
         using (38):(place(block, column(1))):(unit(block, column(1))) with labels left notitle, \
     for [block in 'properties consequences'] for [c = 0:1] value('data_' . block) \
         using (61 + 26 * c):(place(block, column(1))):(number(column(2 + 2 * c))):(column(6) == 0 ? 0xd55e00 : colour(column(2 + 2 * c), column(3 + 2 * c), column(6))) \
         with labels right tc rgb variable notitle, \
     for [block in 'properties consequences'] for [c = 0:1] value('data_' . block) \
         using (73 + 26 * c):(place(block, column(1))):(column(6) == 0 ? '–' : printed(column(3 + 2 * c), column(6))) with labels right notitle
