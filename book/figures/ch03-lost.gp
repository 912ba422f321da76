# Wrong answers a run of the unguarded loop, by the number of points, for
# points at random and for houses along a street.
# alt: Wrong answers in a run over the number of points, both axes
# logarithmic. For houses along a street the curve rises; for points at
# random it stays far below.
# demo: plot
height = 2.3
load "book/figures/style.gp"
table = data . "/ch03-lost.tsv"
set datafile missing NaN
set logscale xy
set xlabel "points"
set ylabel "wrong answers in a run"
set xrange [100:5000]
set yrange [0.01:3000]
set format y "%g"
lost(n) = n > 0.01 ? n : 0.01 # none: on the axis
of(name) = strcol(1)[1:strlen(name)] eq name ? lost(column("mean_wrong")) : NaN
plot table using "n":(of("street")) title "houses along a street", \
     "" using "n":(of("uniform")) title "points at random"
