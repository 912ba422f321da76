# One small picture for every generator.
# alt: Eight small squares with points: spread evenly, in clusters, on a
# lattice, on a circle, crowded around a center, at two places, at one
# place, on a line.
height = 2.75
load "book/figures/style.gp"
table = data . "/ch01-portraits.tsv"
names = "uniform clustered lattice circle kuzmin two-clusters equal collinear"
set multiplot layout 2,4 margins 0.01,0.99,0.02,0.92 spacing 0.03,0.09
unset tics; unset grid; unset key
set border 15 ls 10
set size ratio -1
do for [k = 1:words(names)] {
  name = word(names, k)
  set title name offset 0,-0.8
  low = name eq "kuzmin" ? -6 : name eq "clustered" ? -0.25 : -0.05
  set xrange [low:1 - low]; set yrange [low:1 - low]
  plot table using (strcol(1) eq name ? $2 : NaN):3 with points pt 7 ps 0.17 lc rgb "black"
}
unset multiplot
