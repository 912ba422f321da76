# Uniform and clustered points, each colored by its furthest.
# alt: Two maps of points in shades, one for each furthest point:
# regions with straight borders that fan out; the furthest points,
# ringed, lie on the rim.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch10-regions.tsv"
of(name, k) = strcol(1) eq name ? column(k) : NaN
set palette defined (0 "#14447c", 1 "#f0b48c", 2 "#7fb394", 3 "#d8cfe0", \
  4 "#8c6d1f", 5 "#c4511a", 6 "#555555", 7 "#7a4a94")
unset colorbox; unset tics; unset grid; unset border; unset key
set size ratio -1
set cbrange [0:7]
set multiplot layout 1,2 margins 0.02,0.98,0.03,0.97 spacing 0.04,0
do for [name in "uniform clustered"] {
  set xrange [*:*]; set yrange [*:*]
  stats table using (of(name, 2)):(of(name, 3)) nooutput
  set xrange [STATS_min_x - 0.01:STATS_max_x + 0.01]
  set yrange [STATS_min_y - 0.01:STATS_max_y + 0.01]
  plot table using (of(name, 2)):3:(int($4) % 8) with points pt 7 ps 0.28 lc palette, \
       table using (of(name, 2)):($5 > 0 ? $3 : NaN) with points pt 6 ps 0.9 lc rgb "black"
}
unset multiplot
