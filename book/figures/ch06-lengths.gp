# Nanoseconds an element of the primitives against the bytes that they
# touch, with the sizes of the caches: a panel for each primitive.
# alt: Six panels on the same logarithmic axes, nanoseconds an element
# over the bytes touched. Elementwise arithmetic, gather in order, scan
# and pack rise a little where a cache is full; gather and scatter at
# random rise by more than ten times beyond the third cache. For scan
# and pack the vector instructions are below plain C everywhere.
height = 4.1
load "book/figures/style.gp"
table = data . "/ch06-lengths.tsv"
array at[3]
stats table using "l1" nooutput; at[1] = STATS_max / 1024
stats table using "l2" nooutput; at[2] = STATS_max / 1024
stats table using "l3" nooutput; at[3] = STATS_max / 1024
set datafile missing NaN
set logscale x 2
set logscale y 10
set yrange [0.05:40]
set xrange [3:180000]
do for [c = 1:3] {
  if (at[c] < 180000) {
    set arrow c from at[c], graph 0 to at[c], graph 1 nohead ls 11
    set label c sprintf("L%d", c) at at[c], graph 0.93 right offset -0.2,0
  }
}
of(name, k) = strcol(1) eq name ? column(k) : NaN
names = "elementwise gather_in_order gather_at_random scan pack scatter_at_random"
array titles[6] = ["elementwise", "gather in order", "gather at random", \
  "scan", "pack", "scatter at random"]
set multiplot layout 2,3 margins 0.08,0.985,0.11,0.95 spacing 0.025,0.09
unset key
do for [k = 1:6] {
  set title titles[k] offset 0,-0.6
  if (k > 3) {
    set xtics ("4 K" 4, "64 K" 64, "1 M" 1024, "16 M" 16384)
  } else {
    set xtics ("" 4, "" 64, "" 1024, "" 16384)
  }
  if (k % 3 == 1) {
    set ytics ("0.1" 0.1, "1" 1, "10" 10)
    set ylabel "ns an element" offset 1
  } else {
    set ytics ("" 0.1, "" 1, "" 10)
    unset ylabel
  }
  if (k == 5) { set xlabel "working set, bytes" } else { unset xlabel }
  plot table using ($2/1024):(of(word(names, k), "portable_ns")) \
         with linespoints lt 1 pt 7 ps 0.5, \
       "" using ($2/1024):(of(word(names, k), "vector_ns")) \
         with linespoints lt 2 pt 6 ps 0.6
}
unset multiplot
