# Nanoseconds a point over the length of the strips, by primitives and
# fused. Vertical: where a strip fills the caches.
# alt: Nanoseconds a point over the tasks in a strip, both axes
# logarithmic, by primitives and fused. Both fall to a valley between
# the first and the second cache and rise after it.
# demo: plot
height = 2.5
load "book/figures/style.gp"
table = data . "/ch08-strips.tsv"
stats table using "l1_tasks" name "l1" nooutput
stats table using "l2_tasks" name "l2" nooutput
set logscale x 2
set logscale y 2
set xlabel "tasks in a strip"
set ylabel "ns a point"
set xrange [3.5:80000]
set xtics ("4" 4, "16" 16, "64" 64, "256" 256, "1024" 1024, "4096" 4096, "16384" 16384, "65536" 65536)
set arrow from l1_max,graph 0 to l1_max,graph 1 nohead ls 11
set arrow from l2_max,graph 0 to l2_max,graph 1 nohead ls 11
set label "L1" at l1_max,graph 0.95 offset 0.6
set label "L2" at l2_max,graph 0.95 offset 0.6
set key bottom left
plot table using "length":"primitives_q1":(0):(column("primitives_q3") - column("primitives_q1")) with vectors nohead lt 2 dt 1 notitle, \
     "" using "length":"primitives" with linespoints lt 2 title "by primitives", \
     "" using "length":"fused_q1":(0):(column("fused_q3") - column("fused_q1")) with vectors nohead lt 1 dt 1 notitle, \
     "" using "length":"fused" with linespoints lt 1 title "fused"
