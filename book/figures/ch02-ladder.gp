# Nanoseconds a pair at every step of the ladder, and the limits.
# alt: Nanoseconds a pair at each step from the first version to the
# tiles, on a logarithmic axis, for both geometries. The curves fall in
# steps and end close above horizontal lines, the limits.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch02-ladder.tsv"
cell(row, column) = system(sprintf("awk -F '\t' '$1 == \"%s\" { print $%d }' %s", row, column, table)) + 0
set logscale y
set xrange [-0.4:6.4]
low = cell("limit_tiles", 2) < 0.1 ? 0.02 : 0.1
set yrange [low:1.5*cell("first", 5)]
set ytics ("0.02" 0.02, "0.05" 0.05, "0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20)
set ylabel "ns a pair"
set key top right
set rmargin 16
do for [column = 2:5:3] {
  up = cell("limit", column) > cell("limit_tiles", column) ? 0.4 : -0.4
  set label "limit" at graph 1.02, first cell("limit", column) offset 0,up
  set label "limit of tiles" at graph 1.02, first cell("limit_tiles", column) offset 0,-up
}
steps = sprintf("< grep -v '^limit' %s", table)
plot cell("limit", 5) with lines ls 11 dt 1 notitle, \
     cell("limit", 2) with lines ls 11 dt 1 notitle, \
     cell("limit_tiles", 5) with lines ls 11 dt (3,3) notitle, \
     cell("limit_tiles", 2) with lines ls 11 dt (3,3) notitle, \
     steps using 0:5:6:7 with yerrorbars lt 2 dt 1 notitle, \
     "" using 0:5:xtic(1) with linespoints lt 2 title "wraparound", \
     "" using 0:2:3:4 with yerrorbars lt 1 notitle, \
     "" using 0:2 with linespoints lt 1 title "standard"
