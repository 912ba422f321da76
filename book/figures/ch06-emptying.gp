# The share of the points that are still on their way after k steps, and
# what of it will not stay forever.
# alt: The percentage of points still on their way over the number of
# steps, both axes logarithmic. It falls to a level that stays; what is
# above that level falls along a straight line.
height = 2.2
load "book/figures/style.gp"
table = data . "/ch06-emptying.tsv"
set logscale xy
set xlabel "steps k"
set ylabel "percent of the points"
set yrange [0.02:150]
set xrange [1:2500]
set key outside top center vertical maxrows 2
# The share that stays forever and the fall of the rest, from two rows.
stats table using ($2 == 120 ? $3 : NaN) nooutput; early = STATS_max
stats table using ($2 == 921 ? $3 : NaN) nooutput; late = STATS_max
stay = (921 * late - 120 * early) / 801
fall = 120 * (early - stay)
plot table using 2:3 with linespoints lt 1 ps 0.4 title "on their way", \
     stay with lines ls 11 title "on their way forever", \
     table using 2:($3 > stay ? $3 - stay : NaN) with points lt 2 ps 0.5 title "the others among them", \
     fall / x with lines lt 3 title sprintf("%.0f/k", fall)
