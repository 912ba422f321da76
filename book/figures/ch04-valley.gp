# Sorting and searching together against the number of points in a cell,
# nanoseconds a point with quartiles.
# alt: Nanoseconds a point over the points in a cell, from one half to
# sixteen, three curves of ten sizes each, both axes logarithmic. Lists
# are at the top and rise from the left end to the right, several fold.
# Sorted cells begin a little below them, are level from one half to
# one, as far as one can see, and then rise, slowly up to ten points in
# a cell and steeply after that. Batches of four are far below both. At
# their left end they fall, from one half to one, have their lowest
# place near one, and rise from there on, several fold. So only their
# curve has a left side.
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
