# The corners of the hull of uniform points, over their number.
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
     table using "n":(uniform(column("corners"))) with points lt 1 ps 0.9 title "corners", \
     "" using "n":(uniform(column("asked"))) with points lt 2 ps 0.8 title "somebody's furthest"
