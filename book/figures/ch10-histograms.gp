# The furthest distances in both geometries.
# alt: Histograms of the furthest distances: in the standard geometry a
# wide hill, with wraparound a narrow one close to its largest value.
# demo: plot
height = 1.9
load "book/figures/style.gp"
table = data . "/ch10-histograms.tsv"
set style data boxes
set boxwidth 1 relative
set style fill solid 0.6 noborder
unset key; unset ytics; unset grid
set border 1 ls 10
set multiplot layout 1,2 margins 0.05,0.95,0.16,0.86 spacing 0.1,0
set title "furthest, standard"
set xtics 0.2
set xrange [0.65:1.5]
set yrange [0:*]
plot table using "standard_at":"standard" lt 1
set title "furthest, wraparound"
set xrange [*:*]
stats table using "wraparound_at" nooutput
set xtics STATS_min + 0.15*(STATS_max - STATS_min), 0.35*(STATS_max - STATS_min)
set format x "%.4f"
plot table using "wraparound_at":"wraparound" lt 2
unset multiplot
