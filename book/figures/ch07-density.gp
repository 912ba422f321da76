# Distances a point over the points in a cell: expected, counted, by
# three simpler rules, and by the report's formula.
# alt: Distances a point over the points in a cell. The circles of the
# exact rule lie on the expected curve; all simpler rules are above it,
# and the formula as printed is furthest from it.
# demo: plot
height = 3.2
load "book/figures/style.gp"
expected = data . "/ch07-expected.tsv"
counted = data . "/ch07-density.tsv"
rules = data . "/ch07-rules.tsv"
rule(name) = strcol("name")[1:strlen(name)] eq name ? column("distances") : NaN
set xlabel "points in a cell, c"
set ylabel "distances a point"
set xrange [0:4.2]
set yrange [0:32]
set tmargin at screen 0.76
set key at screen 0.08,0.98 left top Left reverse vertical maxrows 4 samplen 2.2
plot expected using "c":"distances" with lines lt 1 title "expected", \
     counted using "c":"distances" with points lt 1 pt 6 ps 0.9 title "counted", \
     expected using "c":"one_more" with lines lt 2 title "one layer more, expected", \
     rules using "c":(rule("one_more")) with points lt 2 title "one layer more, counted", \
     rules using "c":(rule("d_layers")) with points lt 4 pt 12 title "D layers, D to the first", \
     rules using "c":(rule("whole_layers")) with points lt 3 title "whole layers, as far as D", \
     expected using "c":"printed" with lines lt 6 title "the formula as printed", \
     "+" using (1):(17) every ::0::0 with points pt 3 ps 1.2 lc rgb "black" title "Su's 17"
