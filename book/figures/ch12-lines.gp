# Points looked at by the worst of boxes, over the number of points.
# alt: Points looked at over the number of points, from a thousand to a
# million, both axes logarithmic. Two rising lines, predicted, with marks
# on them, counted: the line in the plane rises with the square root of
# the number of points, the wall in space with its power two thirds.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch12-lines.tsv"
of(d, value) = column("d") == d ? value : NaN
set logscale xy
set format x powers
set format y powers
set xrange [700:1.5e6]
set xlabel "points"
set ylabel "looked at"
set key top left Left reverse
set datafile missing NaN
plot table using "n":(of(2, column("predicted"))) with lines title "line in the plane, predicted", \
  table using "n":(of(2, column("tested"))) with points title "counted", \
  table using "n":(of(3, column("predicted"))) with lines title "wall in space, predicted", \
  table using "n":(of(3, column("tested"))) with points title "counted"
