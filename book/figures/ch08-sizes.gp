# Distances a point, one by one and in step, uniform and clustered.
# Dots: medians; lines: from the quartiles to the extremes.
# alt: Distances a point over the number of points, in step and one by
# one, for uniform and for clustered points. In step needs about one
# distance more.
# demo: plot
height = 2.4
load "book/figures/style.gp"
table = data . "/ch08-sizes.tsv"
of(kind, k) = strcol("kind") eq kind ? column(k) : NaN
set logscale x
set xlabel "points"
set xrange [600:6000000]
set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6)
set yrange [0:*]
set key bottom right
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.9 spacing 0.1
do for [kind in "uniform clustered"] {
  set title kind
  set ylabel (kind eq "uniform" ? "distances a point" : "")
  plot for [k = 1:2] table using "n":(of(kind, word("vector sequential", k) . "_q3")):(0):(column(word("vector sequential", k) . "_max") - column(word("vector sequential", k) . "_q3")) with vectors nohead lt k dt 1 notitle, \
       for [k = 1:2] "" using "n":(of(kind, word("vector sequential", k) . "_q1")):(0):(column(word("vector sequential", k) . "_min") - column(word("vector sequential", k) . "_q1")) with vectors nohead lt k dt 1 notitle, \
       for [k = 1:2] "" using "n":(of(kind, word("vector sequential", k))) with points lt k title (k == 1 ? "in step" : "one by one")
}
unset multiplot
