# A query with ten results, put to three structures, against the number
# of numbers; nanoseconds with quartiles.
# alt: Nanoseconds a query over the number of numbers, at ten thousand,
# a hundred thousand and a million, both axes logarithmic. Looking at
# all rises in a straight line, tenfold for ten times as many numbers.
# The sorted array and the bins rise slowly and do not cross: the bins
# are below at each size, clearly at the first two and a little at the
# last. At the left end both are a hundred times and more below looking
# at all, at the right end thousands of times.
height = 2.5
load "book/figures/style.gp"
table = data . "/ch04-intervals.tsv"
set logscale xy
set format x powers
set format y powers
set xlabel "numbers, N"
set ylabel "ns a query" offset -0.5
set xrange [7e3:1.4e6]
set yrange [10:1e7]
plot table using "n":"few":"few_q1":"few_q3" every 3::0 with yerrorlines lt 1 title "look at all", \
     "" using "n":"few":"few_q1":"few_q3" every 3::1 with yerrorlines lt 2 title "sorted, halves", \
     "" using "n":"few":"few_q1":"few_q3" every 3::2 with yerrorlines lt 3 title "bins"
