# Time to bring a structure in line with points that move.
# alt: Nanoseconds a point to bring each structure in line, over the
# longest motion of a point in mean spacings, from none to ten, the vertical axis
# logarithmic. Those that are built anew are level. The projection begins
# low and jumps where it has to sort anew. The refitted k-d tree is level
# and low.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch12-motion.tsv"
of(name, value) = strcol("structure") eq name ? value : NaN
shown(length) = length > 0 ? length : 0.0003
set logscale xy
set xrange [0.0002:15]
set xtics ("0" 0.0003, "0.001" 0.001, "0.01" 0.01, "0.1" 0.1, "1" 1, "10" 10)
set xlabel "longest motion of a point, in mean spacings"
set ylabel "nanoseconds a point"
set key outside right top Left reverse
set datafile missing NaN
plot for [name in "projection kd-tree kd-tree-anew orthotree-compressed cells cells-halves"] \
  table using (shown(column("length"))):(of(name, column("update"))) title name
