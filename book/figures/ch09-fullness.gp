# The sort that carries, the search, and both, over the number of points
# in a cell.
# alt: Nanoseconds a point over the points in a cell: the search falls
# and then rises a little, the sort is nearly level, and their sum has a
# wide valley.
height = 2.7
load "book/figures/style.gp"
table = data . "/ch09-fullness.tsv"
set logscale x 2
set xlabel "points in a cell, c"
set ylabel "ns a point"
set xrange [0.45:6.6]
set yrange [0:*]
set xtics ("1/2" 0.5, "3/4" 0.75, "1" 1, "1 1/2" 1.5, "2" 2, "3" 3, "4" 4, "6" 6)
set key top center horizontal
plot table using "c":(column("sort") + column("search")) with linespoints lt 1 title "both", \
     "" using "c":"search":"search_q1":"search_q3" with yerrorlines lt 2 title "search", \
     "" using "c":"sort":"sort_q1":"sort_q3" with yerrorlines lt 3 title "sort"
