# Nanoseconds an element of the primitives against the bytes that they
# touch, with the sizes of the caches.
height = 2.7
load "book/figures/style.gp"
table = data . "/ch06-lengths.tsv"
stats table using "l1" nooutput; l1 = STATS_max / 1024
stats table using "l2" nooutput; l2 = STATS_max / 1024
stats table using "l3" nooutput; l3 = STATS_max / 1024
set datafile missing NaN
set logscale x 2
set logscale y 10
set xtics ("4 K" 4, "64 K" 64, "1 M" 1024, "16 M" 16384)
set ytics (0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50)
set yrange [0.06:25]
set xrange [3:180000]
do for [c = 1:3] {
  at = c == 1 ? l1 : c == 2 ? l2 : l3
  if (at < 180000) {
    set arrow c from at, graph 0 to at, graph 1 nohead ls 11
    set label c sprintf("L%d", c) at at, graph 0.04 left offset 0.4,0
  }
}
of(name, k) = strcol(1) eq name ? column(k) : NaN
lines = "gather_at_random scatter_at_random gather_in_order elementwise scan pack"
array titles[6] = ["gather at random", "scatter at random", "gather in order", "elementwise", "scan", "pack"]
array shapes[6] = [7, 5, 9, 2, 4, 6]
set multiplot layout 1,2 margins 0.09,0.98,0.15,0.75 spacing 0.03
set xlabel "working set, bytes" offset 0,0.3
set label 10 "portable" at graph 0.5,1.05 center
set ylabel "ns an element" offset 1
set key at screen 0.53,0.995 center top vertical maxrows 3 samplen 2
plot for [k = 1:6] table using ($2/1024):(of(word(lines, k), "portable_ns")) \
  with linespoints lt k pt shapes[k] ps 0.5 title titles[k]
set label 10 "vector instructions"
unset ylabel
unset key
set format y ""
plot for [k = 1:6] table using ($2/1024):(of(word(lines, k), "vector_ns")) \
  with linespoints lt k pt shapes[k] ps 0.5
unset multiplot
