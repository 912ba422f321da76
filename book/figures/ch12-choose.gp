# Microseconds a box, its share of a build and its query, over the
# number of boxes that share the build.
# alt: Two plots of microseconds a box over the number of boxes that
# share a build, both axes logarithmic. The scan is level. Every other
# line falls and then becomes level. Left, even points that move a
# little: the line of the refitted k-d tree is the first to cross the
# scan, at about ten boxes, and cells cross the tree at some thousands.
# Right, Kuzmin's disc: the compressed orthotree crosses the scan first,
# and the k-d tree crosses the orthotree at some tens of thousands.
# demo: plot
height = 3.3
load "book/figures/style.gp"
moved = data . "/ch12-motion.tsv"
kinds = data . "/ch12-kinds.tsv"
names = "scan-lanes kd-tree kd-tree-anew orthotree-compressed cells cells-halves"
# k stands for a name; a column of its row where the points are such.
even(value) = strcol("structure") eq word(names, k) && \
  column("length") == 0.01 ? value : NaN
disc(value) = strcol("structure") eq word(names, k) && \
  strcol("kind") eq "kuzmin" ? value : NaN
array built[words(names)]
array moved_ns[words(names)]
array made[words(names)]
array disc_ns[words(names)]
set datafile missing NaN
do for [k = 1:words(names)] {
  stats moved using (even(column("update") * column("n"))) nooutput
  built[k] = STATS_mean
  stats moved using (even(column("ns"))) nooutput
  moved_ns[k] = STATS_mean
  stats kinds using (disc(column("build") * column("n"))) nooutput
  made[k] = STATS_mean
  stats kinds using (disc(column("ns"))) nooutput
  disc_ns[k] = STATS_mean
}
set logscale xy
set format xy powers
set xrange [1:1e5]
set yrange [0.8:2e4]
set samples 200
set xlabel "boxes that share a build"
set multiplot layout 1,2 margins 0.1,0.98,0.33,0.89 spacing 0.1
unset key
set title "even points, moved a little"
set ylabel "microseconds a box"
plot for [j = 1:words(names)] (built[j] / x + moved_ns[j]) / 1000 with lines ls j
set key at screen 0.54,0.04 bottom center maxrows 2 Left reverse
set title "Kuzmin's disc"
unset ylabel
# Points that rest need no tree that can be refitted: one is enough.
plot for [j = 1:words(names)] (j == 2 ? NaN : (made[j] / x + disc_ns[j]) / 1000) \
  with lines ls j title word(names, j)
unset multiplot
