# Pairs of boxes looked at for each triangle.
# alt: Pairs of boxes looked at for each triangle over the number of
# triangles, both axes logarithmic. All pairs rise as the number of
# triangles, the sweep as its power two thirds. The k-d tree and the
# cells are level at some tens, the clusters level at about twenty.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch13-broad.tsv"
of(name, value) = strcol("broad") eq name && column("giant") == 0 ? value : NaN
set logscale xy
set format x powers
set xlabel "triangles"
set ylabel "pairs of boxes looked at, per triangle"
set key outside right center
set datafile missing NaN
plot for [name in "all-pairs sweep sweep-and-prune kd-tree cells clusters"] \
  table using "triangles":(of(name, column("tested"))) title name noenhanced
