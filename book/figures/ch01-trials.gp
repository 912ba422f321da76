# The same work, timed again and again, in microseconds, with its median
# and its mean.
# demo: plot
height = 2.5
load "book/figures/style.gp"
table = data . "/ch01-trials.tsv"
us(name) = sprintf("< awk -F '\t' '$1 == \"%s\"' %s", name, table)
set datafile nocolumnheaders
stats us("trial") using ($3/1000) name "T" nooutput
set xlabel "trial"
set ylabel "microseconds"
set xrange [0:T_records]
set yrange [T_min*0.95:T_median*1.5]
set key top right
plot us("trial") using 2:($3/1000) with points pt 7 ps 0.2 lc rgb "#14447c" title "one trial", \
     T_mean with lines ls 11 title "mean", \
     T_median with lines lt 2 dt 1 title "median"
