# Nanoseconds a point in each loop of the search by primitives: predicted
# from the prices, and measured.
# alt: Predicted and measured nanoseconds a point for each of the loops
# of the search; the pairs are of similar height.
# demo: plot
height = 2.1
load "book/figures/style.gp"
table = data . "/ch08-bill.tsv"
set style fill solid 0.6 border
set boxwidth 0.32 absolute
set xrange [-0.6:3.6]
set yrange [0:*]
set ylabel "ns a point"
set xtics ("sort" 0, "layers" 1, "cells" 2, "points" 3)
unset grid
set grid ytics lc rgb "#dddddd" lw 0.5 dt 1
set key top left
place(name) = name eq "sort" ? 0 : name eq "layers" ? 1 : name eq "cells" ? 2 : name eq "points" ? 3 : NaN
spot(offset) = strcol("loop") eq "sum" ? place(strcol("name")) + offset : NaN
plot table using (spot(-0.18)):"predicted" with boxes lt 2 dt 1 fs pattern 4 title "predicted", \
     "" using (spot(0.18)):"measured" with boxes lt 1 title "measured", \
     "" using (spot(0.18)):"measured_q1":(0):(column("measured_q3") - column("measured_q1")) with vectors nohead lt -1 lw 2 notitle
