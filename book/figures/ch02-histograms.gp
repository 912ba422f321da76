# Nearest and furthest distances of 100,000 points in both geometries.
# alt: Four histograms of distances. The nearest ones rise steeply and
# have a long tail on the right; the furthest ones rise slowly to a peak
# near their end.
height = 3.2
load "book/figures/style.gp"
table = data . "/ch02-histograms.tsv"
set style data boxes
set boxwidth 1 relative
set style fill solid 0.6 noborder
unset key
unset ytics
set border 1 ls 10
unset grid
# About four ticks of 1, 2 or 5 units, with as many places as they need.
unit(range) = 10**floor(log10(range/3))
ticks(range) = unit(range)*(range/3 < 1.5*unit(range) ? 1 : \
  range/3 < 3.5*unit(range) ? 2 : range/3 < 7.5*unit(range) ? 5 : 10)
places(step) = step < 1 ? ceil(-log10(step) - 0.01) : 0
set multiplot layout 2,2 margins 0.05,0.95,0.08,0.91 spacing 0.1,0.24
do for [kind = 0:3] {
  set title (kind == 0 ? "nearest, standard" : kind == 1 ? "furthest, standard" : \
             kind == 2 ? "nearest, wraparound" : "furthest, wraparound")
  set xrange [*:*]
  set yrange [*:*]
  stats table using (column(2*kind + 1)) nooutput
  left = kind % 2 ? STATS_min - 0.03*(STATS_max - STATS_min) : 0
  right = STATS_max + 0.03*(STATS_max - left)
  step = ticks(right - left)
  set xrange [left:right]
  set xtics step
  set format x sprintf("%%.%df", places(step))
  set yrange [0:*]
  plot table using (column(2*kind + 1)):(column(2*kind + 2)) lt (kind < 2 ? 1 : 2)
}
unset multiplot
