# Nanoseconds a point for the cell sort with one thread and with all
# processors; each sort gets its memory anew.
# alt: Nanoseconds a point of four cell sorts, on one thread and on all
# processors. On one thread the atomic sort is slowest, then the serial
# one, the private one and the partition, which is fastest; two threads
# take about half to two thirds of the time.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch05-sorts.tsv"
set style fill solid 0.35 border
set ylabel "ns a point"
set xrange [-0.6:3.6]
set yrange [0:*]
set key top right
set xtics scale 0 ("serial" 0, "atomic" 1, "private" 2, "partition" 3)
# Of the two partitions, the one in fresh memory, as the others have it.
at(name) = strstrt(name, "_serial") ? 0 : strstrt(name, "_atomic") ? 1 : \
           strstrt(name, "_private") ? 2 : strstrt(name, "_fresh") ? 3 : NaN
# Chapter 4's sort has only one thread.
more(name) = strstrt(name, "_serial") ? NaN : at(name)
set boxwidth 0.36 absolute
plot table using (at(strcol(1)) - 0.19):"one" with boxes lt 1 fs solid 0.35 title "one thread", \
     "" using (more(strcol(1)) + 0.19):"all" with boxes lt 2 fs pattern 4 title "all processors"
