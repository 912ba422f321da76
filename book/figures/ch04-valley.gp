# Sorting and searching together against the number of points in a cell,
# nanoseconds a point with quartiles.
# alt: Nanoseconds a point over the points in a cell, three curves on
# logarithmic axes. Lists are above sorted cells, and the batched search
# is below both, with its lowest place near one point in a cell.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch04-valley.tsv"
set logscale xy 2
set xlabel "points in a cell, c"
set ylabel "ns a point" offset 1
set xrange [0.45:18]
set xtics ("1/2" 0.5, "1" 1, "2" 2, "4" 4, "8" 8, "16" 16)
plot table using "c":"lists":"lists_q1":"lists_q3" with yerrorlines lt 1 title "lists", \
     "" using "c":"sorted":"sorted_q1":"sorted_q3" with yerrorlines lt 2 title "sorted", \
     "" using "c":"batches":"batches_q1":"batches_q3" with yerrorlines lt 3 title "batches of four"
