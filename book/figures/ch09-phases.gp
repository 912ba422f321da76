# Every phase on one thread and on all processors, beside the floor.
# alt: Nanoseconds a point of each phase, on one thread and on all
# processors, beside the floor, which is a small part of the whole.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch09-phases.tsv"
set style data histograms
set style histogram clustered gap 1
set boxwidth 0.9
set ylabel "ns a point"
set yrange [0:*]
set bmargin 3
set key outside top center horizontal
set xtics ("fit" 0, "sort,\ncopy" 1, "parti-\ntion" 2, "by\n8" 3, "by\n1,024" 4, "search" 5, "in\nplace" 6, "all" 7, "floor" 8) scale 0
plot table using "one" lt 1 fs solid 0.35 title "one thread", \
     "" using "all" lt 2 fs pattern 4 title "all processors"
