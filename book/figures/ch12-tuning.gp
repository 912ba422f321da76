# Time of a query over the points in a leaf, or in a cell.
# alt: Time of a query over the number of points in a leaf or a cell,
# from 2 to 128, both axes logarithmic: six lines, for the k-d tree, the
# cells and the cells with binary search, each with small and with large
# boxes. Each line has a flat valley; beyond it the cells rise the most.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch12-tuning.tsv"
of(name, value) = strcol("structure") eq name ? value : NaN
set logscale xy
set xrange [1.7:150]
set xtics (2, 4, 8, 16, 32, 64, 128)
set format y powers
set xlabel "points in a leaf or a cell"
set ylabel "nanoseconds a query"
set key outside right top Left reverse
set datafile missing NaN
plot for [name in "kd-tree cells cells-halves"] \
  table using "size":(of(name, column("small"))) title name . ", small boxes", \
  for [name in "kd-tree cells cells-halves"] \
  table using "size":(of(name, column("large"))) title name . ", large boxes"
