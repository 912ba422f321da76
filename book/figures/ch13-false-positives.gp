# Candidates and events over the length of a step.
# alt: Candidates for each triangle, those that no direction keeps apart,
# and those with an event, over the length of a step, both axes
# logarithmic. The candidates are level and begin to rise at a step of a
# tenth. Those with an event rise all the way, in proportion to the step
# at first.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch13-false-positives.tsv"
above(x) = x > 0 ? x : NaN
set logscale xy
set xlabel "step, in radii of a body"
set ylabel "pairs per triangle"
set key bottom right
set datafile missing NaN
plot table using "step":(above(column("candidates"))) title "candidates", \
  table using "step":(above(column("narrow"))) title "left by twelve directions", \
  table using "step":(above(column("hits"))) title "with an event"
