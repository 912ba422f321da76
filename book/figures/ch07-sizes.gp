# Distances a point over the number of points. Dots: medians; lines: from
# the quartiles to the extremes.
# alt: Distances a point over the number of points, with one and with
# two points in a cell. Medians approach the expected line, and the
# spread shrinks.
# demo: plot
height = 2.5
load "book/figures/style.gp"
table = data . "/ch07-sizes.tsv"
density = data . "/ch07-density.tsv"
expected(row) = strcol("name") eq row ? column("expected") : NaN
set logscale x
set xlabel "points"
set xrange [600:17000000]
set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6, "10^7" 1e7)
unset key
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.9 spacing 0.1
do for [name in "one two"] {
  set yrange [*:*]
  stats density using (expected(name)) nooutput
  line = STATS_max
  set title name . " in a cell"
  set ylabel (name eq "one" ? "distances a point" : "")
  set yrange [0.94 * line:1.02 * line]
  plot line with lines ls 11, \
       table using "n":(column(name . "_q3")):(0):(column(name . "_max") - column(name . "_q3")) with vectors nohead lt 1 dt 1, \
       "" using "n":(column(name . "_q1")):(0):(column(name . "_min") - column(name . "_q1")) with vectors nohead lt 1 dt 1, \
       "" using "n":(column(name)) with points lt 1
}
unset multiplot
