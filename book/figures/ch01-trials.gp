# The same work, timed again and again, in microseconds, with its median
# and its mean. Trials above the frame stand as triangles at its upper
# edge.
# alt: The time of each trial as a dot. Nearly all lie close to the
# median; those far above it stand as triangles at the upper edge. The
# mean lies above nearly all trials.
# demo: plot
height = 2.5
load "book/figures/style.gp"
table = data . "/ch01-trials.tsv"
us(name) = sprintf("< awk -F '\t' '$1 == \"%s\"' %s", name, table)
set datafile nocolumnheaders
stats us("trial") using ($3/1000) name "T" nooutput
pull = T_mean - T_median
top = T_mean + 1.2*pull
stats us("trial") using ($3/1000 > top ? 1 : NaN) name "O" nooutput
set xlabel "trial"
set ylabel "microseconds"
set xrange [0:T_records]
set yrange [T_min - 0.3*pull:top + 0.12*pull]
set rmargin 9
set label 1 "mean" at graph 1.01, first T_mean
set label 2 "median" at graph 1.01, first T_median
set key outside top center horizontal samplen 1
plot us("trial") using 2:($3/1000 > top ? NaN : $3/1000) with points pt 7 ps 0.2 lc rgb "#14447c" title "one trial", \
     us("trial") using 2:($3/1000 > top ? top : NaN) with points pt 9 ps 0.6 lc rgb "#c4511a" title sprintf("above the frame: %d", O_records), \
     T_mean with lines ls 11 notitle, \
     T_median with lines lt 2 dt 1 notitle
