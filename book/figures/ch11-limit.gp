# Time of one grid and of pieces over the density around a point.
# alt: Nanoseconds a point over the density around a point, from 1 to
# 32 times that of even points, the density logarithmic. The line of
# pieces stays near 80. That of one grid rises from 42 through 52 at
# four times, crosses it at six, and reaches 194.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch11-limit.tsv"
set logscale x
set xrange [0.9:36]
set yrange [0:*]
set xtics (1, 2, 3, 4, 6, 8, 12, 16, 24, 32)
set xlabel "density around a point, times that of even points"
set ylabel "nanoseconds a point"
set key top left
plot table using "density":"grid" with linespoints title "one grid", \
     "" using "density":"pieces" with linespoints title "pieces"
