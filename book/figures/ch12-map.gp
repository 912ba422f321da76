# The fastest structure, over the number of points and the box.
# alt: Two maps with the number of points along x and the share of the
# range that a side of the box has along y. Each place carries a mark
# for the structure that is the fastest there. Left, where points stay,
# a tree for the whole range and cells below, with binary search for
# boxes that hold many points. Right, with a hundred boxes for each time
# the points move, scans by lanes at a hundred points, cells elsewhere.
# demo: plot
height = 3.2
load "book/figures/style.gp"
table = data . "/ch12-map.tsv"
# The two k-d trees differ only in what they do when points move.
tree(name) = name eq "kd-tree-anew" ? "kd-tree" : name
of(best, name, value) = tree(strcol(best)) eq name ? value : NaN
names = "scan-lanes kd-tree orthotree orthotree-compressed cells cells-halves"
set logscale xy
set format x powers
set xrange [50:3e6]
set yrange [0.0015:2.5]
set xlabel "points"
set grid xtics ytics
set datafile missing NaN
set multiplot layout 1,2 margins 0.14,0.98,0.34,0.89 spacing 0.1
unset key
set title "queries alone"
set ylabel "side of the box"
plot for [name in names] table using "n":(of("stays", name, column("share"))) \
  with points ps 1.2 notitle
set key at screen 0.54,0.04 bottom center maxrows 2 Left reverse
set title "a hundred boxes share a build"
unset ylabel
plot for [name in names] table using "n":(of("hundred", name, column("share"))) \
  with points ps 1.2 notitle, \
  for [k=1:words(names)] NaN with points ls k ps 1.2 title word(names, k)
unset multiplot
