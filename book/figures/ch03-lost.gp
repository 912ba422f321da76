# Wrong answers a run of the unguarded loop, by the number of points, for
# points at random and for houses along a street.
# demo: plot
load "book/figures/style.gp"
table = data . "/ch03-lost.tsv"
set datafile missing NaN
set logscale xy
set xlabel "points"
set ylabel "wrong answers in a run, on average"
set xrange [100:5000]
set format y "%g"
of(name) = strcol(1)[1:strlen(name)] eq name ? column("mean_wrong") : NaN
plot table using "n":(of("street")) title "houses along a street", \
     "" using "n":(of("uniform")) title "points at random"
