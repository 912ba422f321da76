# Build anew or update, over the length of a step.
# alt: Pairs of boxes looked at for each triangle, or swaps, over the
# length of a step, both axes logarithmic. Sweep and prune begins lowest
# and rises as the step until it is at the sweep that is done anew. The
# k-d tree that is refitted begins at that which is built anew and rises
# above it. Clusters are low everywhere.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch13-update.tsv"
of(name, value) = strcol("broad") eq name ? value : NaN
set logscale xy
set xrange [0.0007:1.4]
set xlabel "step, in radii of a body"
set ylabel "looked at or swapped, per triangle"
set key outside right center
set datafile missing NaN
plot for [name in "sweep sweep-and-prune kd-tree kd-tree-anew clusters clusters-prune"] \
  table using "step":(of(name, column("tested"))) title name noenhanced
