# The geometry by pointer, by flag and by copy, in two loops.
# alt: Nanoseconds a pair, on a logarithmic axis, for the geometry by
# pointer, by flag and by copies. On the left, in the coursework's loop,
# the pointer is three to four times as dear as the others in the standard
# geometry, and all are near ten in the wraparound one. On the right, over
# lanes, flag and copies are far below the pointer in both.
height = 2.3
load "book/figures/style.gp"
table = data . "/ch02-dispatch.tsv"
set logscale y
set yrange [0.1:20]
set ytics ("0.1" 0.1, "0.2" 0.2, "0.5" 0.5, "1" 1, "2" 2, "5" 5, "10" 10, "20" 20)
set xrange [-0.6:6.6]
set xtics ("pointer" 0, "flag" 1, "copies" 2, "pointer" 4, "flag" 5, "copies" 6)
set ylabel "ns a pair"
set label "the coursework's loop" at first 1, graph 1.06 center
set label "sixteen queries side by side" at first 5, graph 1.06 center
set arrow from first 3, graph 0 to first 3, graph 1 nohead ls 11
set tmargin 2.5
set key at first 3.1, graph 0.2
set pointsize 1.3
plot table using ($0):2 with linespoints lt 1 title "standard", \
     "" using ($0):5 with linespoints lt 2 title "wraparound", \
     "" using ($0 + 4):8 with linespoints lt 1 notitle, \
     "" using ($0 + 4):11 with linespoints lt 2 notitle
