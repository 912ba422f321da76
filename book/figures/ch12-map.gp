# The fastest structure, over the number of points and the box.
# alt: A map with the number of points along x and the share of the
# range that a side of the box has along y. Each place carries a mark
# for the structure that is the fastest there, where points stay: scans
# at few points and large boxes, cells with binary search elsewhere.
# demo: plot
height = 3.0
load "book/figures/style.gp"
table = data . "/ch12-map.tsv"
of(name, value) = strcol("stays") eq name ? value : NaN
set logscale xy
set format x powers
set xrange [50:3e6]
set yrange [0.0015:2.5]
set xlabel "points"
set ylabel "side of the box"
set key outside right top Left reverse
set grid xtics ytics
set datafile missing NaN
plot for [name in "scan scan-lanes projection kd-tree kd-tree-anew orthotree orthotree-compressed cells cells-halves"] \
  table using "n":(of(name, column("share"))) with points ps 1.3 title name
