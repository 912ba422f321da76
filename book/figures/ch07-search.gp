# One search: the layers of phase one, the square, and the cells that
# phase two looked at, numbered as it went.
# alt: Cells around a query, numbered in the order in which the search
# looked at them, those of phase one and of phase two in different
# shades, with the square of side 2D and a nearer neighbor found in
# phase two.
height = 3.1
load "book/figures/style.gp"
table = data . "/ch07-trace.tsv"
of(name, k) = strcol(1) eq name ? column(k) : NaN
phase(p, k) = strcol(1) eq "cell" && $6 == p ? column(k) : NaN
unset tics; unset grid; unset border
set size ratio -1
do for [name in "cell query first neighbor square"] {
  stats table using (of(name, 2)) name name . "_x" nooutput
  stats table using (of(name, 3)) name name . "_y" nooutput
}
x = query_x_min; y = query_y_min
side = square_x_min; tall = square_y_min
home_x = floor(x); home_y = floor(y)
left = home_x - 2.3; right = home_x + 3.3
bottom = home_y - 2.3; top = home_y + 3.3
set lmargin at screen 0.05; set rmargin at screen 0.66
set bmargin at screen 0.07; set tmargin at screen 0.98
set xrange [left:right]
set yrange [bottom:top]
set key at screen 0.995,0.88 right top Left reverse samplen 1.8 spacing 1.3
set style fill solid 1 noborder
# The square is drawn before the points: one of them is near its corner.
set print $square
print "x\ty"
do for [k = 0:4] {
  print sprintf("%f\t%f", x + (k % 4 < 2 ? -side : side), \
    y + ((k + 1) % 4 < 2 ? -tall : tall))
}
unset print
set for [k = -2:3] arrow from home_x + k,bottom to home_x + k,top \
  nohead ls 10 front
set for [k = -2:3] arrow from left,home_y + k to right,home_y + k \
  nohead ls 10 front
set for [k = -2:2] label sprintf("%d", home_x + k) \
  at home_x + k + 0.5,bottom center offset 0,-0.6 font ",7"
set for [k = -2:2] label sprintf("%d", home_y + k) \
  at left,home_y + k + 0.5 right offset -0.5,0 font ",7"
plot table using (phase(1, 2) + 0.5):($3 + 0.5):(0.5):(0.5) \
       with boxxyerror fc rgb "#b9cde4" title "phase one", \
     "" using (phase(2, 2) + 0.5):($3 + 0.5):(0.5):(0.5) \
       with boxxyerror fc rgb "#C4DFCB" title "phase two", \
     "" using (of("cell", 2) + 0.07):($3 + 0.46):(sprintf("%d", $4)) \
       with labels left font ",7" textcolor rgb "#444444" notitle, \
     $square using 1:2 with lines lc rgb "black" lw 1.4 dt (4,3) \
       title "square of side 2D", \
     table using (of("point", 2)):3 \
       with points pt 7 ps 0.4 lc rgb "#555555" title "points", \
     "" using (of("query", 2)):3 \
       with points pt 7 ps 1.0 lc rgb "black" title "the query", \
     "" using (of("first", 2)):3 \
       with points pt 5 ps 0.9 lc rgb "#c4511a" title "nearest of phase one", \
     "" using (of("neighbor", 2)):3 \
       with points pt 9 ps 1.1 lc rgb "#14447c" title "nearest of all"
