# The share of the points that are still on their way after k steps, and
# what of it will not stay forever, against 58 percent over k.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch06-emptying.tsv"
set logscale xy
set xlabel "steps k"
set ylabel "percent of the points" offset 1
set yrange [0.02:150]
set xrange [1:2500]
set key outside top center vertical maxrows 2
stay = 100 * 1.50659 / (3.0 * 2.25)
plot table using 2:3 with linespoints lt 1 ps 0.4 title "on their way", \
     stay with lines ls 11 title "on their way forever", \
     table using 2:($3 > stay ? $3 - stay : NaN) with points lt 2 ps 0.5 title "the others among them", \
     58 / x with lines lt 3 title "58/k"
