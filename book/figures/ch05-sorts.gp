# Nanoseconds a point for the cell sort with one thread and with all
# processors, and for getting and copying as much memory as it writes.
# alt: Nanoseconds a point of each cell sort, on one thread and on all
# processors, and beside them of getting and copying memory.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch05-sorts.tsv"
set style data histograms
set style histogram clustered gap 1
set boxwidth 0.9
set ylabel "ns a point"
set yrange [0:*]
set bmargin 3
set key top right
set xtics ("serial" 0, "atomic" 1, "private" 2, "parti-\ntion" 3, "same,\nfresh" 4, "small\npages" 5, "large\npages" 6, "copy" 7)
# Chapter 4's sort has only one thread.
all(k) = strcol(1)[1:14] eq "uniform_serial" ? NaN : column(k)
plot table using "one" lt 1 fs solid 0.35 title "one thread", \
     "" using (all("all")) lt 2 fs pattern 4 title "all processors"
