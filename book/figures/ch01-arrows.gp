# Every point with an arrow to its nearest neighbor, and beside it the
# same points with a line to the furthest.
# alt: Thirty points, twice. On the left each has an arrow to its
# nearest neighbor, and many arrows point both ways; on the right each
# has a line to its furthest point, and all lines end at a few points on
# the rim.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch01-arrows.tsv"
set multiplot layout 1,2 margins 0.02,0.98,0.04,0.9 spacing 0.05
set size ratio -1
set xrange [-0.02:1.02]; set yrange [-0.02:1.02]
unset tics; unset grid; unset key
set border 15 ls 10
set title "nearest"
plot table using 1:2:($3-$1):($4-$2) with vectors head size 0.025,20,60 \
       filled lt 1 dt 1 lw 1, "" using 1:2 with points pt 7 ps 0.5 lc rgb "black"
set title "furthest"
plot table using 1:2:($5-$1):($6-$2) with vectors nohead lt 6 dt 1 lw 0.5, \
     "" using 1:2 with points pt 7 ps 0.5 lc rgb "black"
unset multiplot
