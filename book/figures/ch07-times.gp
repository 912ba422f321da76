# Time a point over the number of points, queries as they come and in
# the order of the cells. Dots: medians; lines: from the quartiles to the
# extremes. Vertical: where what is read fills the caches.
# alt: Nanoseconds a point over the number of points, both axes
# logarithmic. The queries as they come take ever longer than those in
# the order of the cells once the data no longer fits the cache.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch07-sizes.tsv"
stats table using "l2_points" name "l2" nooutput
stats table using "l3_points" name "l3" nooutput
set logscale x
set xlabel "points"
set ylabel "ns a point"
set xrange [700:15000000]
set xtics ("1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6, "10,000,000" 1e7)
set logscale y 2
set yrange [60:*]
set arrow from l2_max,graph 0 to l2_max,graph 1 nohead back ls 11
set label "L2" at l2_max,graph 0.95 offset 0.6
if (l3_max < 10000000) {
  set arrow from l3_max,graph 0 to l3_max,graph 1 nohead back ls 11
  set label "L3" at l3_max,graph 0.95 offset 0.6
}
set key bottom right opaque
plot table using "n":"unordered_q3":(0):(column("unordered_max") - column("unordered_q3")) with vectors nohead lt 2 dt 1 notitle, \
     "" using "n":"unordered_q1":(0):(column("unordered_min") - column("unordered_q1")) with vectors nohead lt 2 dt 1 notitle, \
     "" using "n":"unordered" with linespoints lt 2 title "as they come", \
     "" using "n":"ordered_q3":(0):(column("ordered_max") - column("ordered_q3")) with vectors nohead lt 1 dt 1 notitle, \
     "" using "n":"ordered_q1":(0):(column("ordered_min") - column("ordered_q1")) with vectors nohead lt 1 dt 1 notitle, \
     "" using "n":"ordered" with linespoints lt 1 title "in the order of the cells"
