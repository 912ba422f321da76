# A pile over its steps.
# alt: Candidates, pairs in motion, pairs that twelve directions
# leave, and bodies asleep, over the steps of a pile, on a logarithmic
# axis. All rise steeply while the bodies land, until about step 300.
# Then candidates are nearly level, more and more bodies sleep, and
# fewer and fewer pairs are in motion.
# demo: plot
height = 2.7
load "book/figures/style.gp"
table = data . "/ch13-pile.tsv"
above(x) = x > 0 ? x : NaN
set logscale y
set format y powers
set xlabel "step"
set ylabel "pairs or bodies"
set key bottom right
set datafile missing NaN
plot table using "step":(above(column("candidates"))) title "candidates", \
  table using "step":(above(column("paired"))) title "in motion", \
  table using "step":(above(column("narrow"))) title "left by twelve directions", \
  table using "step":(above(column("asleep"))) title "bodies asleep"
