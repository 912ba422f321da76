# The largest share of a thread.
# alt: The largest share of a thread in units of the mean, over the
# number of threads from 2 to 64, both axes logarithmic. By triangle it
# rises most, by pair a little less. By runs of 64 pairs it stays near 1
# up to eight threads.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch13-balance.tsv"
set logscale xy 2
set xrange [1.8:72]
set yrange [0.9:]
set xlabel "threads"
set ylabel "largest share, in means"
plot table using "threads":"work_by_triangle" title "work, by triangle", \
  table using "threads":"work_by_pair" title "work, by pair", \
  table using "threads":"pairs_by_triangle" title "pairs, by triangle", \
  table using "threads":"work_by_runs" title "work, by runs of 64 pairs"
