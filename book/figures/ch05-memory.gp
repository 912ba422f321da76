# Nanoseconds a point of the partition in fresh memory and in memory that
# is kept; and of getting as much memory as it writes, and of copying it.
# alt: Nanoseconds a point, on one thread and on all processors. The
# partition takes longer in fresh memory than in kept memory, by about as
# much as getting its memory in large pages. To get it in small pages
# takes longer than the whole partition.
# demo: plot
height = 2.8
load "book/figures/style.gp"
table = data . "/ch05-sorts.tsv"
set style fill solid 0.35 border
set ylabel "ns a point"
set xrange [-0.6:4.6]
set yrange [0:*]
set bmargin 3
set key top right
set xtics scale 0 ("partition,\nfresh" 0, "partition,\nkept" 1, "get small\npages" 2, "get large\npages" 3, "copy" 4)
at(name) = strstrt(name, "_fresh") ? 0 : strstrt(name, "_partition") ? 1 : \
           strstrt(name, "_small") ? 2 : strstrt(name, "_large") ? 3 : \
           strstrt(name, "_copy") ? 4 : NaN
set boxwidth 0.36 absolute
plot table using (at(strcol(1)) - 0.19):"one" with boxes lt 1 fs solid 0.35 title "one thread", \
     "" using (at(strcol(1)) + 0.19):"all" with boxes lt 2 fs pattern 4 title "all processors"
