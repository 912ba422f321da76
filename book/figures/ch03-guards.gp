# What each guard costs: nanoseconds an ordered pair, on one thread and on
# all processors.
# demo: plot
height = 2.2
load "book/figures/style.gp"
table = data . "/ch03-guards.tsv"
set logscale y
set yrange [0.1:*]
set key outside top center horizontal
set ylabel "nanoseconds a pair"
set style data histograms
set style histogram clustered gap 1
set boxwidth 0.9 relative
set xtics scale 0
plot table using "one_ns":xtic(1) title "one thread" lt 1 fs solid 0.7, \
     "" using (strcol(1) eq "none" ? NaN : column("all_ns")) title "all processors" lt 2 fs pattern 4
