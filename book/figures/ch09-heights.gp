# The whole time a point over the number of points, with the caches.
# alt: Nanoseconds a point over the number of points, both axes
# logarithmic, for four searches; row spans are below the cells, which
# are below the spiral, and the distance grows with the points.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch09-heights.tsv"
stats table using "l2_points" name "l2" nooutput
stats table using "l3_points" name "l3" nooutput
set logscale xy
set xlabel "points"
set ylabel "ns a point"
set xrange [700:15000000]
set xtics ("1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6, "10,000,000" 1e7)
set yrange [10:2000]
set arrow from l2_max,graph 0 to l2_max,graph 1 nohead ls 11
set arrow from l3_max,graph 0 to l3_max,graph 1 nohead ls 11
set label "L2" at l2_max,graph 0.05 offset 0.6
set label "L3" at l3_max,graph 0.05 offset 0.6
set key top left
plot table using "n":"spiral":"spiral_q1":"spiral_q3" with yerrorlines lt 3 title "spiral", \
     "" using "n":"cells":"cells_q1":"cells_q3" with yerrorlines lt 2 title "cells", \
     "" using "n":"spans":"spans_q1":"spans_q3" with yerrorlines lt 1 title "row spans", \
     "" using "n":"kept":"kept_q1":"kept_q3" with yerrorlines lt 4 title "row spans, kept"
