# The search alone, step by step, nanoseconds a point, with quartiles.
# demo: plot
height = 2.6
load "book/figures/style.gp"
table = data . "/ch09-steps.tsv"
unset grid
set grid xtics lc rgb "#dddddd" lw 0.5 dt 1
set xlabel "ns a point"
set xrange [0:*]
set yrange [7.6:-0.6]
set ytics ("through indices" 0, "sorted points" 1, "three spans" 2, "four lanes" 3, "rows passed over" 4, "four ask together" 5, "eight, sifted" 6, "fewer in a cell" 7) scale 0
unset key
plot table using (0):0:(0):"ns":(column(0) - 0.32):(column(0) + 0.32) with boxxyerror ls 12 fs solid 1 border lc rgb "#14447c", \
     "" using "ns":0:"ns_q1":"ns_q3" with xerrorbars lt 1 pt 7
