# What it costs a thread to increment a counter of its own, by the
# distance of the two threads' counters.
# alt: Nanoseconds a step over the distance of the counters. Up to 32
# bytes the time is high, from 64 bytes on it is a third of that.
height = 2.0
load "book/figures/style.gp"
table = data . "/ch03-sharing.tsv"
set logscale x 2
set xlabel "distance of the two counters, bytes"
set ylabel "nanoseconds a step"
set xrange [6:340]
set yrange [0:*]
set xtics (8, 16, 32, 64, 128, 256)
unset key
plot table using "bytes":"ns":"ns_q1":"ns_q3" with yerrorlines pt 7 ps 0.6
