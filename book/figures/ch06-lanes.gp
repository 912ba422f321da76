# One row of the picture as a vector, never packed and packed after
# every eight steps: black is useful work, gray is work for nothing.
# alt: Two pictures of lanes by steps. Never packed, most of the area is
# gray, wasted work; packed after every eight steps, the area shrinks to
# a narrow black block.
height = 1.9
load "book/figures/style.gp"
table = data . "/ch06-lanes.tsv"
set border 0
unset key; unset grid; unset colorbox
set palette defined (0 "white", 1 "#c4c4c4", 2 "black")
set cbrange [0:2]
set autoscale fix
set yrange [*:*] reverse
set ylabel "step"
set xlabel "lane"
set xtics ("0" 0, "60" 60, "120" 120, "180" 180, \
  "0" 256, "60" 316, "120" 376, "180" 436)
set label 1 "never packed" at 120, graph 1.08 center
set label 2 "packed after every eight steps" at 376, graph 1.08 center
set tmargin 1.5
plot table matrix skip 5 using 1:2:3 with image
