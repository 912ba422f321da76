# A query with ten results, put to three structures, against the number
# of numbers; nanoseconds with quartiles.
# alt: Nanoseconds a query over the number of numbers, both axes
# logarithmic. Looking at all rises in a straight line; the sorted array
# and the bins stay far below it.
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
