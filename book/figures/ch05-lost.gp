# The share of its points that each of some 576 cells was said to
# hold: in groups of lanes a cell counts at most once a group; two
# threads lose where they meet.
# alt: The share of the points that was counted, over the points in a
# cell, on a logarithmic axis. All curves begin at one and fall, the
# sooner the more lanes there are in a group.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch05-lost.tsv"
stats table using (strcol(1) eq "all" ? column("right") : NaN) nooutput
n = STATS_max
stats table using (strcol(1) eq "all" ? NaN : column("right")) nooutput
most = STATS_max
set logscale x
set xlabel "points in a cell"
set ylabel "counted, of all"
set format x powers
set xrange [10:2 * most]
set yrange [0:1.05]
set key bottom left
share(k) = strcol(1)[1:4] eq "cell" && column("right") > 0 ? column(k) / column("right") : NaN
seen(k, lanes) = k > most ? NaN : n / lanes * (1 - (1 - k / n)**lanes) / k
set samples 200
# Of the lanes every fifth cell, so that the lines can be seen between
# the marks; of the threads every twelfth, in front and larger.
plot table using "right":(share("lanes8")) every 5 with points lt 1 ps 0.6 title "8 lanes", \
     "" using "right":(share("lanes64")) every 5 with points lt 2 ps 0.6 title "64 lanes", \
     "" using "right":(share("lanes1024")) every 5 with points lt 3 ps 0.6 title "1,024 lanes", \
     seen(x, 8) with lines lt -1 lw 0.8 dt 1 title "predicted", \
     seen(x, 64) with lines lt -1 lw 0.8 dt 1 notitle, \
     seen(x, 1024) with lines lt -1 lw 0.8 dt 1 notitle, \
     table using "right":(share("threads2")) every 12 with points lt 6 ps 1.0 title "two threads"
