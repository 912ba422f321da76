# Points in their cells, and the arrays that the cell sort makes of them:
# where each cell begins, and the points by cell.
# alt: A map of twelve cells, four columns and three rows from the lower
# left corner, with twenty-four numbered points; below it an array of
# thirteen starts, with lines into an array of twenty-four places that
# holds the points cell by cell. The starts of the cells 0 to 11 are 0,
# 2, 5, 5, 7, 11, 12, 16, 19, 21, 21 and 22, and the last cell ends at
# 24. The points are 8, 13 in cell 0; 6, 15, 22 in cell 1; none in cell
# 2; 10, 12 in cell 3; 2, 4, 19, 21 in cell 4; 11 in cell 5; 0, 1, 7, 17
# in cell 6; 3, 9, 20 in cell 7; 16, 18 in cell 8; none in cell 9; 5 in
# cell 10; and 14, 23 in cell 11.
height = 4.3
load "book/figures/style.gp"
table = data . "/ch04-sorted.tsv"
kind(name, value) = strcol(1) eq name ? value : NaN
unset key; unset tics; unset grid; unset border
set multiplot
# ---- the plane
set lmargin at screen 0.2; set rmargin at screen 0.8
set bmargin at screen 0.40; set tmargin at screen 0.995
stats table using (kind("column", $4)) name "x" nooutput
stats table using (kind("row", $5)) name "y" nooutput
set xrange [x_min - 0.02:x_max + 0.05]
set yrange [y_min - 0.02:y_max + 0.03]
plot table using (kind("column", $4)):(y_min):(0):(y_max - y_min) \
       with vectors nohead ls 10, \
     "" using (x_min):(kind("row", $5)):(x_max - x_min):(0) \
       with vectors nohead ls 10, \
     "" using (kind("cell", $4) - 0.078):($5 + 0.11):(sprintf("%d", $6)) \
       with labels font ",20" tc rgb "#b9c7d8", \
     "" using (kind("point", $4)):5 with points pt 7 ps 0.5 lc rgb "black", \
     "" using (kind("point", $4)):5:(sprintf("%d", $3)) \
       with labels offset 1.0,0.4 font ",9"
# ---- the arrays
set lmargin at screen 0.005; set rmargin at screen 0.995
set bmargin at screen 0.0; set tmargin at screen 0.37
set xrange [-0.6:24.6]; set yrange [0:10]
set label 1 "start: where each cell begins" at -0.5,9.5 left
set label 2 "point: the points, cell by cell" at -0.5,0.5 left
across(cell) = cell * 1.94 + 0.45
start(name) = strcol(1) eq "cell" || strcol(1) eq "end" ? across($2) : NaN
plot table using (start(0)):(6.1):($7 - 0.5 - across($2)):(4.3 - 6.1) \
       with vectors nohead lc rgb "#8899aa" lw 0.8, \
     "" using (start(0)):(6.9):(across($2) - 0.7):(across($2) + 0.7):(6.1):(7.7) \
       with boxxyerror fs empty ls 10, \
     "" using (start(0)):(6.9):(sprintf("%d", $7)) with labels font ",10", \
     "" using (start(0)):(8.3):(sprintf("%d", $6)) \
       with labels font ",8" tc rgb "#667788", \
     "" using (kind("point", $2)):(3.5):($2 - 0.5):($2 + 0.5):(2.7):(4.3) \
       with boxxyerror fs empty ls 10, \
     "" using (kind("point", $2)):(3.5):(sprintf("%d", $3)) with labels font ",10", \
     "" using (kind("point", $2)):(1.95):(sprintf("%d", $2)) \
       with labels font ",8" tc rgb "#667788"
unset multiplot
