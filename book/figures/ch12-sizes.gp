# Time of a query over the number of points that the box holds.
# alt: Time of a query over the number of points that a box holds, both
# axes logarithmic. The two scans are nearly level at the top; the
# projection lies below them and rises; the trees and the cells begin a
# thousand times lower and meet the scans where the box holds all.
# demo: plot
height = 3.1
load "book/figures/style.gp"
table = data . "/ch12-sizes.tsv"
of(name, value) = strcol("structure") eq name ? value : NaN
held(name) = of(name, column("found") > 0.3 ? column("found") : 0.3)
set logscale xy
set format x powers
set format y powers
set xlabel "points in the box"
set ylabel "nanoseconds a query"
set key outside right top Left reverse
set datafile missing NaN
plot for [name in "scan scan-lanes projection kd-tree orthotree-compressed cells-halves"] \
  table using (held(name)):(of(name, column("ns"))) title name
