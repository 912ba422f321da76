# The time of the triangular loop with private answers, by schedule and
# chunk, with quartiles.
height = 2.3
load "book/figures/style.gp"
table = data . "/ch03-schedules.tsv"
set logscale x 2
set xlabel "rows in a chunk"
set ylabel "nanoseconds a pair"
set xrange [0.7:1500]
set yrange [0:*]
set xtics (1, 4, 16, 64, 256, 1024)
of(name) = strcol(1)[1:strlen(name)] eq name ? column("ns") : NaN
set key bottom left
plot table using "chunk":(of("static")):"ns_q1":"ns_q3" \
       with yerrorlines title "static", \
     "" using "chunk":(of("dynamic")):"ns_q1":"ns_q3" \
       with yerrorlines title "dynamic", \
     "" using "chunk":(of("guided")):"ns_q1":"ns_q3" \
       with yerrorlines title "guided", \
     "" using (0.7):(of("blocks")):(1500):(0) with vectors nohead ls 11 \
       title "static, one block each"
