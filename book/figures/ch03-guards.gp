# What each guard costs: nanoseconds an ordered pair, on one thread and on
# all processors. Points with quartiles, on a logarithmic scale.
# alt: Nanoseconds an ordered pair for each guard, on one thread and on
# all processors, on a logarithmic axis. The queue is far above the
# rest, and on all processors it is slower still; the private answers
# gain most from them.
# demo: plot
height = 2.4
load "book/figures/style.gp"
table = data . "/ch03-guards.tsv"
set logscale x
set xrange [0.3:*]
set yrange [4.6:-0.6]
set xlabel "nanoseconds an ordered pair"
set grid xtics lc rgb "#dddddd" lw 0.5 dt 1
set key outside top center horizontal
set ytics scale 0 ("no guard" 0, "queue" 1, "look, then queue" 2, \
  "a lock in each best" 3, "private answers" 4)
many(k) = strcol(1) eq "none" ? NaN : column(k)
plot table using "one_ns":($0-0.12):"one_ns_q1":"one_ns_q3" \
       with xerrorbars pt 7 ps 0.7 title "one thread", \
     "" using (many("all_ns")):($0+0.12):"all_ns_q1":"all_ns_q3" \
       with xerrorbars pt 6 ps 0.8 lw 1.3 title "all processors"
