# Nanoseconds a point for the cell sort of points of all kinds, on all
# processors: where the points crowd, atomics queue and a bucket is large.
# alt: Nanoseconds a point of four sorts for five kinds of points. The
# atomic one grows with the crowd to many times the others, which stay
# about level.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch05-crowded.tsv"
set ylabel "ns a point"
set yrange [0:*]
set style data histograms
set style histogram clustered gap 1.5
set boxwidth 0.9
set key outside top center horizontal
set xtics scale 0 ("uniform" 0, "clustered" 1, "two clusters" 2, "kuzmin" 3, "equal" 4)
# The kinds stand in the table in this order, five sorts each; the last
# is the partition in fresh memory, as the others have it.
plot table every 5::0 using "one" lt 6 fs solid 0.25 title "serial, one thread", \
     "" every 5::1 using "all" lt 2 fs pattern 4 title "atomic", \
     "" every 5::2 using "all" lt 3 fs pattern 2 title "private", \
     "" every 5::4 using "all" lt 1 fs solid 0.75 title "partition"
