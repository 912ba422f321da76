# Nanoseconds an element of three packs against the share that is kept,
# and what a branch should cost if the larger side is always guessed.
# alt: Nanoseconds an element over the percentage that is kept. With a
# branch it is a hill with its top at one half; without a branch it is
# level and far below.
# demo: plot
height = 2.2
load "book/figures/style.gp"
table = data . "/ch06-branches.tsv"
set xlabel "kept, percent"
set ylabel "ns an element"
set yrange [0:*]
set key outside top center vertical maxrows 2 samplen 2
stats table using (column("percent") == 50 ? column("branch_ns") : NaN) nooutput
peak = STATS_max
stats table using (column("percent") == 0 ? column("branch_ns") : NaN) nooutput
first = STATS_max
stats table using (column("percent") == 100 ? column("branch_ns") : NaN) nooutput
last = STATS_max
foot(p) = first + (last - first) * p / 100.0
guess(p) = foot(p) + (peak - foot(50)) * (p < 50 ? p : 100 - p) / 50.0
plot table using 2:"branch_ns" with points lt 1 title "with a branch", \
     "" using 2:"branch_ns":"branch_ns_q1":"branch_ns_q3" with yerrorbars lt 1 dt 1 notitle, \
     "" using 2:(guess($2)) with lines ls 11 dt (7,5) title "if only the rarer kind surprises", \
     "" using 2:"portable_ns" with linespoints lt 2 dt (14,6) pi 4 title "without, portable", \
     "" using 2:"vector_ns" with linespoints lt 3 dt (5,5) pi 4 title "without, vectors"
