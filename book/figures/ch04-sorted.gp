# Points in their cells, and the arrays that the cell sort makes of them:
# the points by cell, and where each cell begins.
height = 2.75
load "book/figures/style.gp"
table = data . "/ch04-sorted.tsv"
kind(name, value) = strcol(1) eq name ? value : NaN
unset key; unset tics; unset grid; unset border
set multiplot
# ---- the plane
set lmargin at screen 0.01; set rmargin at screen 0.43
set bmargin at screen 0.04; set tmargin at screen 0.97
stats table using (kind("column", $4)) name "x" nooutput
stats table using (kind("row", $5)) name "y" nooutput
set xrange [x_min - 0.02:x_max + 0.05]
set yrange [y_min - 0.02:y_max + 0.03]
plot table using (kind("column", $4)):(y_min):(0):(y_max - y_min) \
       with vectors nohead ls 10, \
     "" using (x_min):(kind("row", $5)):(x_max - x_min):(0) \
       with vectors nohead ls 10, \
     "" using (kind("cell", $4)):5:(sprintf("%d", $6)) \
       with labels font ",15" tc rgb "#b9c7d8", \
     "" using (kind("point", $4)):5 with points pt 7 ps 0.45 lc rgb "black", \
     "" using (kind("point", $4)):5:(sprintf("%d", $3)) \
       with labels offset 0.9,0.35 font ",7.5"
# ---- the arrays
set lmargin at screen 0.46; set rmargin at screen 0.995
set xrange [-0.6:24.1]; set yrange [0:10]
set label 1 "where each cell begins" at -0.5,9.7 left
set label 2 "the points, cell by cell" at -0.5,0.9 left
across(cell) = cell * 2.0 + 0.4
plot table using (kind("cell", across($2))):(7.3):($7 - 0.5 - across($2)):(3.7 - 7.3) \
       with vectors nohead lc rgb "#8899aa" lw 0.7, \
     "" using (kind("cell", across($2))):(8.0):(across($2) - 0.8):(across($2) + 0.8):(7.3):(8.7) \
       with boxxyerror fs empty ls 10, \
     "" using (kind("cell", across($2))):(8.0):(sprintf("%d", $7)) with labels font ",7.5", \
     "" using (kind("cell", across($2))):(9.05):(sprintf("%d", $6)) \
       with labels font ",6.5" tc rgb "#8899aa", \
     "" using (kind("point", $2)):(3.0):($2 - 0.5):($2 + 0.5):(2.3):(3.7) \
       with boxxyerror fs empty ls 10, \
     "" using (kind("point", $2)):(3.0):(sprintf("%d", $3)) with labels font ",6.5", \
     "" using (kind("point", $2)):(1.85):(sprintf("%d", $2)) \
       with labels font ",5.5" tc rgb "#8899aa"
unset multiplot
