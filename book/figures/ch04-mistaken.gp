# A point, the block of nine cells that was searched for its neighbor, the
# neighbor found there, and the nearer one outside.
# alt: A grid of cells with points. A block of nine cells is shaded; the
# neighbor found in it lies further away than a point just outside of
# the block, inside the circle around the query.
height = 3.1
load "book/figures/style.gp"
table = data . "/ch04-mistaken.tsv"
kind(name, value) = strcol(1) eq name ? value : NaN
of(name, k) = strcol(1) eq name ? column(k) : NaN
unset tics; unset grid; unset border
set size ratio -1
do for [name in "column row query found right low high"] {
  stats table using (of(name, 2)) name name . "_x" nooutput
  stats table using (of(name, 3)) name name . "_y" nooutput
}
left = column_x_min; right = column_x_max
bottom = row_y_min; top = row_y_max
set lmargin at screen 0.02; set rmargin at screen 0.66
set bmargin at screen 0.03; set tmargin at screen 0.97
set xrange [left - 0.02:right + 0.02]
set yrange [bottom - 0.02:top + 0.02]
set key at screen 0.99,0.9 right top Left reverse samplen 1.5 spacing 1.3
set object 1 rectangle from low_x_min,low_y_min to high_x_min,high_y_min \
  fs solid 1 noborder fc rgb "#e3eaf2" behind
distance = sqrt((query_x_min - right_x_min)**2 + (query_y_min - right_y_min)**2)
set object 2 circle at query_x_min,query_y_min size distance \
  fs empty border rgb "black" front
plot table using (kind("column", $2)):(bottom):(0):(top - bottom) \
       with vectors nohead ls 10 notitle, \
     "" using (left):(kind("row", $3)):(right - left):(0) \
       with vectors nohead ls 10 notitle, \
     "" using (kind("point", $2)):3 with points pt 7 ps 0.35 lc rgb "#555555" notitle, \
     "" using (kind("query", $2)):3:(found_x_min - query_x_min):(found_y_min - query_y_min) \
       with vectors nohead lt 2 notitle, \
     "" using (kind("query", $2)):3:(right_x_min - query_x_min):(right_y_min - query_y_min) \
       with vectors nohead lt 1 notitle, \
     "" using (kind("query", $2)):3 with points pt 7 ps 0.9 lc rgb "black" title "the query", \
     "" using (kind("found", $2)):3 with points pt 5 ps 0.8 lc rgb "#c4511a" title "found in the block", \
     "" using (kind("right", $2)):3 with points pt 9 ps 1.0 lc rgb "#14447c" title "its nearest neighbor"
