# Nearest and furthest distances of 100,000 points in both geometries.
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
set multiplot layout 2,2 margins 0.04,0.96,0.08,0.91 spacing 0.1,0.24
do for [kind = 0:3] {
  set title (kind == 0 ? "nearest, standard" : kind == 1 ? "furthest, standard" : \
             kind == 2 ? "nearest, wraparound" : "furthest, wraparound")
  if (kind % 2 == 0) { set xrange [0:0.006]; set xtics 0.002 }
  if (kind == 1) { set xrange [0.6:1.5]; set xtics 0.2 }
  if (kind == 3) { set xrange [1.4095:1.4145]; set xtics 0.002 }
  set format x kind == 1 ? "%.1f" : "%.3f"
  set yrange [0:*]
  plot table using (column(2*kind + 1)):(column(2*kind + 2)) lt (kind < 2 ? 1 : 2)
}
unset multiplot
