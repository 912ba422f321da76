# Nanoseconds a pair against the size of a block.
# alt: One curve, nanoseconds a pair over the candidates in a block: a
# flat valley in the middle that rises at both ends.
height = 1.9
load "book/figures/style.gp"
table = data . "/ch02-blocks.tsv"
set logscale x 2
set xlabel "candidates in a block"
set ylabel "ns a pair"
set yrange [0:*]
set xrange [12:5400]
set xtics ("16" 16, "64" 64, "256" 256, "1,024" 1024, "4,096" 4096)
unset key
plot table using 2:3:4:5 with yerrorbars lt 1, "" using 2:3 with linespoints lt 1
