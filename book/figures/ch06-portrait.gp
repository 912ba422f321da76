# The points of the plane, darker the longer they are on their way.
# alt: The Mandelbrot set in black, with gray levels around it that are
# darker near its border.
height = 2.2
load "book/figures/style.gp"
table = data . "/ch06-portrait.tsv"
set border 15 ls 10
unset key; unset grid; unset colorbox
set size ratio -1
set palette gray negative
set cbrange [0:8]
set autoscale fix
set xtics ("−2" (-2 + 2.2) / 0.0125, "−1" (-1 + 2.2) / 0.0125, "0" 2.2 / 0.0125) out
set ytics ("−1" (1 + 1.125) / 0.0125, "0" 1.125 / 0.0125, "1" (1.125 - 1) / 0.0125) out
set yrange [*:*] reverse
shade(k) = k >= 256 ? 8 : (log(k) / log(2) - 1.5) * 1.15
plot table matrix skip 5 using 1:2:(shade($3)) with image
