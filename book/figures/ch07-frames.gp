# One search in four frames: the cell of the query; layer 1; the square;
# the cells of phase two.
# alt: Four frames of one search. First, only the cell of the query has
# been visited, and it is empty. Second, the eight cells around it, two
# of which have a point; the nearer is at distance D. Third, the square
# of side 2D, which reaches into the next column on the left and the
# next row above. Fourth, the seven cells there have been visited, and
# one on the left has a nearer point.
height = 1.55
load "book/figures/style.gp"
table = data . "/ch07-trace.tsv"
of(name, k) = strcol(1) eq name ? column(k) : NaN
upto(n, p) = strcol(1) eq "cell" && $4 <= n && $6 == p ? column(2) : NaN
unset tics; unset grid; unset border; unset key
set size ratio -1
do for [name in "query first neighbor square"] {
  stats table using (of(name, 2)) name name . "_x" nooutput
  stats table using (of(name, 3)) name name . "_y" nooutput
}
x = query_x_min; y = query_y_min
side = square_x_min; tall = square_y_min
left = floor(x) - 2.2; right = floor(x) + 2.2
bottom = floor(y) - 1.2; top = floor(y) + 3.2
set xrange [left:right]; set yrange [bottom:top]
set style fill solid 1 noborder
set for [k = -2:2] arrow from floor(x) + k,bottom to floor(x) + k,top \
  nohead ls 10 front
set for [k = -1:3] arrow from left,floor(y) + k to right,floor(y) + k \
  nohead ls 10 front
set multiplot layout 1,4 margins 0.005,0.995,0.02,0.86 spacing 0.012
array visits[4] = [1, 9, 9, 16]
array titles[4] = ["visit 1", "visits 2 to 9", "the square", \
  "visits 10 to 16"]
do for [f = 1:4] {
  n = visits[f]
  set title titles[f]
  unset object
  if (f > 2) {
    set object 1 rectangle from x - side,y - tall to x + side,y + tall \
      fs empty border rgb "black" lw 1.2 dt (4,3) front
  }
  plot table using (upto(n, 1) + 0.5):($3 + 0.5):(0.5):(0.5) \
         with boxxyerror fc rgb "#b9cde4", \
       "" using (upto(n, 2) + 0.5):($3 + 0.5):(0.5):(0.5) \
         with boxxyerror fc rgb "#C4DFCB", \
       "" using (of("point", 2)):3 with points pt 7 ps 0.3 lc rgb "#555555", \
       "" using (of("query", 2)):3 with points pt 7 ps 0.8 lc rgb "black", \
       "" using (f > 1 ? of("first", 2) : NaN):3 \
         with points pt 5 ps 0.7 lc rgb "#c4511a", \
       "" using (f > 3 ? of("neighbor", 2) : NaN):3 \
         with points pt 9 ps 0.9 lc rgb "#14447c"
}
unset multiplot
