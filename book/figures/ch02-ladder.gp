# Nanoseconds a pair at every step of the ladder, and the limits.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch02-ladder.tsv"
limit(row, column) = system(sprintf("awk -F '\t' '$1 == \"%s\" { print $%d }' %s", row, column, table))
set logscale y
set xrange [-0.4:6.4]
set yrange [0.1:20]
set ylabel "ns a pair"
set key top right
steps = sprintf("< grep -v '^limit' %s", table)
plot steps using 0:5:6:7 with yerrorbars lt 2 dt 1 notitle, \
     "" using 0:5:xtic(1) with linespoints lt 2 title "wraparound", \
     "" using 0:2:3:4 with yerrorbars lt 1 notitle, \
     "" using 0:2 with linespoints lt 1 title "standard", \
     limit("limit", 5) + 0 with lines ls 11 title "the adders' limit", \
     limit("limit", 2) + 0 with lines ls 11 notitle, \
     limit("limit_handed", 5) + 0 with lines ls 11 dt (1,3) title "with the multipliers' help", \
     limit("limit_handed", 2) + 0 with lines ls 11 dt (1,3) notitle
