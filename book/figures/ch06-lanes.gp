# One row of the picture as a vector, never packed and packed after
# every eight steps: black is useful work, gray is work for nothing.
height = 1.9
load "book/figures/style.gp"
table = data . "/ch06-lanes.tsv"
set border 0
unset key; unset grid; unset colorbox
set palette defined (0 "white", 1 "#c4c4c4", 2 "black")
set cbrange [0:2]
set autoscale fix
set yrange [*:*] reverse
set ylabel "step" offset 1
set xlabel "lane"
set xtics ("0" 0, "120" 120, "240" 240, "0" 256, "120" 376, "240" 496)
set title "never packed                                             packed after every eight steps" offset 0,-0.5
plot table matrix using 1:2:3 with image
