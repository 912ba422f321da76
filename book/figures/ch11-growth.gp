# Distances a point over the number of points: by pieces, on all kinds.
# alt: Distances a point over the number of points, both axes
# logarithmic. The lines of all nineteen kinds of points stay between 1
# and 100 from a thousand to a million points; single marks, those of one grid
# on two of them rise in proportion to the number of points.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch11-growth.tsv"
kind(name, value) = strcol(1)[1:strlen(name)+1] eq name . "_" ? value : NaN
set logscale xy
set xlabel "points"
set ylabel "distances a point"
set xrange [700:1500000]
set yrange [0.3:20000]
set xtics ("1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6)
set key top right
set datafile missing NaN
plot table using "n":(kind("kuzmin", column("one_grid"))) with points lt 2 pt 4 title "one grid: Kuzmin's disc", \
     "" using "n":(kind("two_clusters", column("one_grid"))) with points lt 3 pt 6 title "one grid: two clusters", \
     "" using "n":"near" with points lt 1 pt 7 ps 0.4 title "nearest by pieces, all kinds", \
     "" using "n":"far" with points lt 5 pt 1 ps 0.6 title "furthest by pieces, all kinds"
