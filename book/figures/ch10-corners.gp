# The corners of the hull of uniform points, over their number.
# alt: The corners of the hull over the number of points, on a
# logarithmic axis: they follow a straight line that rises. Those that
# are the furthest of any point stay at about six.
# demo: plot
height = 2.2
load "book/figures/style.gp"
table = data . "/ch10-corners.tsv"
uniform(value) = strcol(1)[1:7] eq "uniform" ? value : NaN
set logscale x
set xlabel "points"
set ylabel "corners"
set xrange [70:15000000]
set xtics ("100" 100, "1,000" 1000, "10,000" 10000, "100,000" 100000, "1,000,000" 1e6, "10,000,000" 1e7)
set yrange [0:*]
set key top left
plot 8.0/3*(log(x) + 0.5772 - log(2)) with lines lt 6 title "expected", \
     table using "n":(uniform(column("corners"))) with points lt 1 pt 7 ps 0.9 title "corners of the hull", \
     "" using "n":(uniform(column("asked"))) with points lt 2 pt 4 ps 0.9 title "furthest of at least one point"
