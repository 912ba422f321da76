# Nanoseconds for a useful step against how often the lanes are packed,
# in short and in long vectors, and what the prices predict.
# alt: Nanoseconds a useful step over the steps between two packings,
# both axes logarithmic. Short vectors and one long one each have a
# valley in the middle, near the predicted curve.
# demo: plot
height = 2.2
load "book/figures/style.gp"
table = data . "/ch06-balance.tsv"
prices = data . "/ch06-prices.tsv"
price(name, column_name) = sprintf("%s %s", name, column_name)
set logscale x 2
set logscale y 2
set xlabel "steps between two packings"
set ylabel "ns a useful step" offset 1
set xrange [0.9:300]
set xtics (1, 2, 4, 8, 16, 32, 64, 128, "never" 256)
set key top center
of(name, k) = strcol(1) eq name ? column(k) : NaN
array a[2]; array q[2]
do for [v = 1:2] {
  level = v == 1 ? "l1_ns" : "l2_ns"
  stats prices using (of("elementwise", level)) nooutput
  a[v] = v == 1 ? 3 * STATS_max : 2 * STATS_max
  sum = 0
  do for [w = 1:5] {
    stats prices using (of(word("pack gather32_in_order gather_in_order scatter_in_order elementwise", w), level)) nooutput
    sum = sum + STATS_max * (w == 3 ? 5 : 1)
  }
  q[v] = sum
}
plot table using "every":"short_ns" with points lt 1 title "short vectors, measured", \
     "" using "every":((a[1] + q[1] / column("every")) * column("done")) with lines lt 1 dt 1 lw 0.8 title "short vectors, predicted", \
     "" using "every":"long_ns" with points lt 2 title "one long vector, measured", \
     "" using "every":((a[2] + q[2] / column("every")) * column("done")) with lines lt 2 dt (10,5) lw 1 title "one long vector, predicted"
