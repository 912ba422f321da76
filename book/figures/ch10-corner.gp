# Two searches by the corner trick: the circle, the cells with a part
# outside, the point found, and where the corner is empty the one missed.
# alt: Two maps of cells with points and a circle's arc near the upper
# right corner. On the left the cells outside of the circle hold the
# furthest point; on the right the corner cell is empty and a further
# point is missed.
height = 2.75
load "book/figures/style.gp"
table = data . "/ch10-corner.tsv"
of(name, k) = strcol(1) eq name ? column(k) : NaN
unset tics; unset grid; unset border
set size ratio -1
set key at screen 0.5,0.0 center bottom horizontal maxrows 1 Left reverse samplen 1 width -1
set multiplot layout 1,2 margins 0.02,0.98,0.12,0.99 spacing 0.04,0
do for [panel in "sound broken"] {
  set xrange [*:*]; set yrange [*:*]
  do for [name in "grid query radius"] {
    stats table using (of(panel . "_" . name, 2)) name name . "_x" nooutput
    stats table using (of(panel . "_" . name, 3)) name name . "_y" nooutput
  }
  if (panel eq "broken") { unset key }
  m = grid_x_max; rows = grid_y_max
  set xrange [-0.1:m + 0.1]
  set yrange [-0.1:rows + 0.1]
  unset arrow; unset object
  set for [k = 0:m] arrow from k,0 to k,rows nohead lc rgb "#bbbbbb" lw 0.6 back
  set for [k = 0:rows] arrow from 0,k to m,k nohead lc rgb "#bbbbbb" lw 0.6 back
  set object 1 ellipse center query_x_max,query_y_max \
    size 2*radius_x_max,2*radius_y_max fs empty border lc rgb "black" lw 1.2 front
  plot table using (of(panel . "_cell", 2) + 0.5):($3 + 0.5):(0.5):(0.5) \
         with boxxyerror fs solid 1 noborder fc rgb "#f0d3c2" notitle, \
       "" using (of(panel . "_point", 2)):3 with points pt 7 ps 0.28 lc rgb "#555555" notitle, \
       "" using (of(panel . "_query", 2)):3 with points pt 7 ps 0.9 lc rgb "black" title "query", \
       "" using (of(panel . "_found", 2)):3 with points pt 5 ps 0.8 lc rgb "#c4511a" title "found", \
       "" using (panel eq "broken" ? of("broken_right", 2) : -9):3 \
         with points pt 9 ps 1.0 lc rgb "#14447c" title "missed"
}
unset multiplot
