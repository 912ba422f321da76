# Distances for each point against the number of points: cells that hold
# two points, and cells that hold as many as there are cells.
# alt: Distances a point over the number of points, both axes
# logarithmic. With two points in a cell the curve is level; with as
# many points in a cell as there are cells it rises along a straight
# line.
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
