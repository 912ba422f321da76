# A walk through memory in random order: nanoseconds a step against lines.
# alt: Nanoseconds a step against the number of lines, 64 to 65,536, both
# axes logarithmic. Packed lines cost about one nanosecond in the first
# cache and more with each cache they outgrow. Lines on a page of their own
# each cost more from some hundred on, and far more from thousands on.
height = 2.3
load "book/figures/style.gp"
table = data . "/ch02-chase.tsv"
set logscale xy
set xlabel "lines of 64 bytes"
set ylabel "ns a step"
set xrange [55:80000]
set yrange [0.7:*]
set xtics ("64" 64, "256" 256, "1,024" 1024, "4,096" 4096, "16,384" 16384, "65,536" 65536)
set ytics ("1" 1, "2" 2, "5" 5, "10" 10, "20" 20, "50" 50, "100" 100, "200" 200, "500" 500)
set key top left
plot table using 2:7 with linespoints lt 2 title "each on a page of its own", \
     "" using 2:7:8:9 with yerrorbars lt 2 dt 1 notitle, \
     "" using 2:4 with linespoints lt 1 title "packed together", \
     "" using 2:4:5:6 with yerrorbars lt 1 notitle
