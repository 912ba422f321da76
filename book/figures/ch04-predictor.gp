# Wrong guesses for each query against the length of the predictor's
# history, for uniform points and a lattice.
# alt: Two curves fall from about 18 wrong guesses for each query. That of
# the uniform points ends at about 15; that of the lattice falls steeply
# between 6 and 12 outcomes of history and ends near 3.
# demo: plot
height = 2.5
load "book/figures/style.gp"
table = data . "/ch04-predictor.tsv"
set xlabel "outcomes of earlier branches that the predictor looks at"
set ylabel "wrong guesses a query" offset 1
set xrange [-1:33]
set yrange [0:22]
set key bottom left
plot table using "length":"uniform" with linespoints lt 1 title "uniform points", \
     table using "length":"lattice" with linespoints lt 2 title "lattice"
