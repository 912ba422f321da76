# Distances for each point against the number of points: cells that hold
# two points, and cells that hold as many as there are cells.
# alt: Distances a point over the number of points, from 100 to 409,600
# in seven sizes, each four times the one before; both axes logarithmic.
# With two points in a cell the curve begins at thirteen, bends upward
# to seventeen at the second size, and is level from then on, close
# below a thin level line at 18, which stands for nine full cells. With
# as many points in a cell as there are cells it begins at 58 and rises,
# doubling at each size in the end, to more than five thousand. It stays
# below a second thin line, 9 √n, again nine full cells, and comes ever
# closer to it.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch04-crowding.tsv"
set logscale xy
set format x powers
set xlabel "points, n"
set ylabel "distances a point" offset 1
set yrange [5:20000]
plot table using "n":"root" with linespoints lt 2 title "cells of √n points", \
     9 * sqrt(x) with lines ls 11 title "9 √n", \
     table using "n":"two" with linespoints lt 1 title "cells of two points", \
     18 with lines lt 6 title "18"
