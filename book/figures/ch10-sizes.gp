# The whole time a point over the number of points: the nearest, the
# furthest, and both.
# alt: Nanoseconds a point over the number of points, both axes
# logarithmic, for five searches. Both answers together are highest; the
# furthest by the candidate grid is lowest.
# demo: plot
height = 3.3
load "book/figures/style.gp"
table = data . "/ch10-sizes.tsv"
set logscale xy
set xlabel "points"
set ylabel "ns a point"
set xrange [700:15000000]
set yrange [5:*]
set xtics ("1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6, "10,000,000" 1e7)
set key outside top center horizontal maxrows 2
plot table using "n":"both":"both_q1":"both_q3" with yerrorlines lt 4 title "both, near and far", \
     "" using "n":"cells":"cells_q1":"cells_q3" with yerrorlines lt 2 title "furthest, by cells", \
     "" using "n":"spans":"spans_q1":"spans_q3" with yerrorlines lt 1 title "nearest, row spans", \
     "" using "n":"hull":"hull_q1":"hull_q3" with yerrorlines lt 3 title "furthest, by the hull", \
     "" using "n":"far":"far_q1":"far_q3" with yerrorlines lt 5 title "furthest, candidate grid"
