# Lines of equal distance from one point: plainly, to the closest image
# and to the furthest image.
# alt: Lines of equal distance around one point, three times: circles;
# circles that meet in edges where two images of the point are equally
# close; and, for the furthest image, arcs that enclose a place half a
# side away.
height = 1.85
load "book/figures/style.gp"
table = data . "/ch01-images.tsv"
set multiplot layout 1,3 margins 0.01,0.99,0.03,0.86 spacing 0.03
set view map
set contour base
unset surface
set cntrparam levels incremental 0.1,0.1,1.4
set cntrlabel onecolor
set linetype 1 lw 0.9 dt 1
unset tics; unset grid; unset key
set border 15 ls 10
set size ratio -1
set xrange [0:1]; set yrange [0:1]
set label 1 "" at 0.2,0.3 point pt 7 ps 0.6 lc rgb "black" front
set title "standard" offset 0,-0.5
splot table using 1:2:3 with lines lt 1
set title "closest image"
splot table using 1:2:4 with lines lt 1
set title "furthest image"
splot table using 1:2:5 with lines lt 1
unset multiplot
