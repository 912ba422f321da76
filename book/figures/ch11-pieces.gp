# The pieces of Kuzmin's disc, the middle of it, with some of the points.
# alt: Two squares with points that crowd in the middle. In the left one
# a square grid of equal cells: nearly all points are in one. In the
# right one rectangles, small where points crowd and large where they do
# not.
# demo: apart
height = 2.8
load "book/figures/style.gp"
table = data . "/ch11-boxes.tsv"
set multiplot layout 1,2
set size ratio -1
set xrange [-12:12]
set yrange [-12:12]
unset xtics
unset ytics
unset key
set grid
dot(value) = column("n") == 0 ? value : NaN
box(value) = column("n") > 0 ? value : NaN
set for [k=-12:12:6] arrow from k,-12 to k,12 nohead lw 0.7
set for [k=-12:12:6] arrow from -12,k to 12,k nohead lw 0.7
plot table using (dot(column("left"))):"bottom" with points lt 1 pt 7 ps 0.15
unset arrow
plot table using (box((column("left")+column("right"))/2)):((column("bottom")+column("top"))/2):"left":"right":"bottom":"top" with boxxyerror lt 1 lw 0.7 fs empty, \
     table using (dot(column("left"))):"bottom" with points lt 1 pt 7 ps 0.15
unset multiplot
