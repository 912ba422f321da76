# The time of the triangular loop with private answers, by schedule and
# chunk, with quartiles; side by side where they would cover each other.
# alt: Nanoseconds an ordered pair over the rows in a chunk. Static and dynamic
# chunks lie together below, guided ones far above, at the line for one
# block each.
height = 2.6
load "book/figures/style.gp"
table = data . "/ch03-schedules.tsv"
set logscale x 2
set xlabel "rows in a chunk"
set ylabel "nanoseconds an ordered pair"
set xrange [0.7:1500]
stats table using "ns_q1" nooutput
set yrange [0.9*STATS_min:*]
set xtics (1, 4, 16, 64, 256, 1024)
of(name) = strcol(1)[1:strlen(name)] eq name ? column("ns") : NaN
set key outside top center horizontal maxrows 1 samplen 3
plot table using (0.88*column("chunk")):(of("static")):"ns_q1":"ns_q3" \
       with yerrorlines pt 6 ps 0.8 title "static", \
     "" using "chunk":(of("dynamic")):"ns_q1":"ns_q3" \
       with yerrorlines pt 5 ps 0.6 title "dynamic", \
     "" using (1.14*column("chunk")):(of("guided")):"ns_q1":"ns_q3" \
       with yerrorlines pt 8 ps 0.9 title "guided", \
     "" using (0.7):(of("blocks")):(1500):(0) with vectors nohead ls 11 \
       title "one block each"
