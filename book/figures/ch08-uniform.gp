# Time a point with the sort, one by one and in step, uniform points.
# Dots: medians; lines: from the quartiles to the extremes.
# alt: Nanoseconds a point over the number of uniform points, both axes
# logarithmic, for three searches. The one in step is lowest, the one by
# one as they come rises most.
# demo: plot
height = 2.4
load "book/figures/style.gp"
table = data . "/ch08-sizes.tsv"
of(k) = strcol("kind") eq "uniform" ? column(k) : NaN
set logscale x
set logscale y 2
set xlabel "points"
set ylabel "ns a point"
set xrange [700:5000000]
set yrange [32:*]
set xtics ("1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6)
set key top left
names = "unordered ordered in_step"
type(k) = k == 1 ? 2 : k == 2 ? 3 : 1
plot for [k = 1:3] table using "n":(of(word(names, k) . "_q3")):(0):(column(word(names, k) . "_max") - column(word(names, k) . "_q3")) with vectors nohead lt type(k) dt 1 notitle, \
     for [k = 1:3] "" using "n":(of(word(names, k) . "_q1")):(0):(column(word(names, k) . "_min") - column(word(names, k) . "_q1")) with vectors nohead lt type(k) dt 1 notitle, \
     for [k = 1:3] "" using "n":(of(word(names, k))) with linespoints lt type(k) title (k == 1 ? "one by one, as they come" : k == 2 ? "one by one, in the order of the cells" : "in step")
