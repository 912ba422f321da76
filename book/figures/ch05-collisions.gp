# Losers among all points, by the number of lanes in a group: marks are
# counted, lines expected; thin, half the lanes times the points in a
# cell.
# alt: Losers over the lanes in a group, both axes logarithmic, for five
# kinds of points. For uniform and clustered points they rise in
# straight lines, for the crowded kinds they are near their most
# everywhere.
# demo: plot
height = 3.1
load "book/figures/style.gp"
table = data . "/ch05-collisions.tsv"
set logscale xy
set logscale x 2
set xlabel "lanes in a group"
set ylabel "losers"
set format x "2^{%L}"
set format y powers
set key bottom right
set xrange [6:*]
set yrange [4:300000]
# A table has other lengths, too; the longest groups tell which is ours.
stats table using (column("lanes")) nooutput
n = STATS_max
of(kind, k) = strcol(1)[1:strlen(kind)] eq kind && column("n") == n ? column(k) : NaN
plot table using "lanes":(of("equal", "losers_expected")) with lines lt 5 lw 0.9 notitle, \
     "" using "lanes":(of("equal", "losers")) with points lt 5 ps 1.6 title "equal", \
     "" using "lanes":(of("kuzmin", "losers_expected")) with lines lt 4 lw 0.9 notitle, \
     "" using "lanes":(of("kuzmin", "losers")) with points lt 4 title "kuzmin", \
     "" using "lanes":(of("two_clusters", "losers_expected")) with lines lt 3 lw 0.9 notitle, \
     "" using "lanes":(of("two_clusters", "losers")) with points lt 3 title "two clusters", \
     "" using "lanes":(of("clustered", "losers_expected")) with lines lt 2 lw 0.9 notitle, \
     "" using "lanes":(of("clustered", "losers")) with points lt 2 title "clustered", \
     "" using "lanes":(of("uniform", "losers_expected")) with lines lt 1 lw 0.9 notitle, \
     "" using "lanes":(of("uniform", "losers")) with points lt 1 title "uniform", \
     "" using "lanes":(of("uniform", "pairs_expected")) with lines ls 11 lw 0.6 notitle
