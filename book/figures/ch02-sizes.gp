# Nanoseconds a pair against the number of points.
# alt: Nanoseconds a pair over the number of points, three curves. All
# fall at first; the one that reads every candidate for one point rises
# again for many points, the others stay level.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch02-sizes.tsv"
set logscale x 2
set xlabel "points"
set ylabel "ns a pair"
set yrange [0:*]
set key outside top center vertical maxrows 3
set xrange [450:300000]
set xtics ("1,024" 1024, "4,096" 4096, "16,384" 16384, "65,536" 65536, "262,144" 262144)
plot table using 2:4 with linespoints lt 1 title "lanes: one query, eight candidates", \
     "" using 2:4:5:6 with yerrorbars lt 1 notitle, \
     "" using 2:7 with linespoints lt 2 title "queries: eight queries, one candidate", \
     "" using 2:7:8:9 with yerrorbars lt 2 dt 1 notitle, \
     "" using 2:10 with linespoints lt 3 title "tiles: and the multipliers subtract", \
     "" using 2:10:11:12 with yerrorbars lt 3 dt 1 notitle
