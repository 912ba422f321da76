# How often each cell around the point is looked at, of a hundred
# searches: counted, and expected.
# alt: Two squares of five by five cells with the percentage of searches
# that look at each, counted and expected: the query's own cell always,
# its neighbors more than half of the time, the outer ones less than
# once in a hundred. Both squares agree.
height = 2.75
load "book/figures/style.gp"
table = data . "/ch07-visits.tsv"
unset tics; unset grid; unset border; unset key
set size ratio -1
set style fill solid 1 noborder
set xrange [-2.5:2.5]; set yrange [-2.5:2.5]
set palette defined (0 "#ffffff", 1 "#9db9d8")
set cbrange [0:1]
unset colorbox
set multiplot layout 1,2 margins 0.02,0.98,0.03,0.9 spacing 0.04
percent(p) = p < 0.0995 ? sprintf("%.2f", 100 * p) : sprintf("%.1f", 100 * p)
inside(dx, dy, v) = abs(dx) <= 2 && abs(dy) <= 2 ? v : NaN
set for [k = 0:5] arrow from k - 2.5,-2.5 to k - 2.5,2.5 nohead ls 10 front
set for [k = 0:5] arrow from -2.5,k - 2.5 to 2.5,k - 2.5 nohead ls 10 front
do for [what in "counted expected"] {
  set title what
  plot table using (inside($3, $4, $3)):4:(0.5):(0.5):(column(what)) \
         with boxxyerror fc palette notitle, \
       "" using (inside($3, $4, $3)):4:(percent(column(what))) \
         with labels font ",8" notitle
}
unset multiplot
