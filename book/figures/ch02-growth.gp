# The mean nearest distance against the number of points.
# alt: The mean nearest distance over the number of points, as a
# multiple of the expected one. In the standard geometry it begins above
# one and falls toward it along the predicted curve; with wraparound it
# stays at one.
height = 2.3
load "book/figures/style.gp"
table = data . "/ch02-growth.tsv"
set logscale x
set xlabel "points"
set ylabel "mean nearest distance · 2√n"
set xrange [80:80000]
set xtics ("100" 100, "1,000" 1000, "10,000" 10000)
set yrange [0.98:1.06]
set key top right
plot table using 2:3 with linespoints lt 1 title "standard", \
     table using 2:4 with linespoints lt 2 title "wraparound", \
     1 + 2*4*(0.0514 + 0.041/sqrt(x))/sqrt(x) with lines lt 6 title "Donnelly's edge effect", \
     1 with lines ls 11 title "1/(2√n)"
