# The share of wrong neighbors if nine cells are searched and no test is
# made, against the number of points in a cell: expected and counted.
# alt: The share of wrong neighbors over the points in a cell, from a
# quarter to four, both axes logarithmic. The expected curve falls ever
# more steeply: from one in seven at a quarter of a point through three
# in a thousand at one and fifty-five in a million at two to four in a
# hundred million at four. Six circles, the counted values at 1/4, 1/2,
# 1, 3/2, 2 and 3, lie on it, the last a little below. At four there is
# none, as no wrong neighbor was counted.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch04-counts.tsv"
set logscale x 2
set logscale y
set xrange [0.22:4.5]
set yrange [1e-8:1]
set format y (format eq "dumb" ? "%g" : powers)
set xlabel "points in a cell, c"
set ylabel "share of wrong neighbors" offset -0.5
set key top right
set xtics ("1/4" 0.25, "1/2" 0.5, "1" 1, "2" 2, "3" 3, "4" 4)
q(k) = 2 * erf(2 * k) - erf(k) + (exp(-4 * k * k) - exp(-k * k)) / (k * sqrt(pi))
set samples 200
plot [0.22:4.1] 1 - q(sqrt(pi * x))**2 with lines lt 1 title "expected", \
     table using "c":(column("wrong") > 0 ? column("wrong") : NaN) \
       with points pt 6 ps 0.9 lc rgb "black" title "counted"
