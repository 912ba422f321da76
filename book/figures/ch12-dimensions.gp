# Points looked at for each point found, over the dimension.
# alt: Points looked at for each point that is found, over the number of
# dimensions, one to eight, the vertical axis logarithmic. All
# structures rise. In one dimension the cells and the trees look at less
# than one; in eight at hundreds, and the projection at the most.
# demo: plot
height = 2.9
load "book/figures/style.gp"
table = data . "/ch12-dimensions.tsv"
of(name, value) = strcol("structure") eq name && value > 0 ? value : NaN
set logscale y
set format y powers
set xrange [0.5:8.5]
set xtics 1,1,8
set xlabel "dimensions"
set ylabel "looked at, for one found"
set key bottom right
set datafile missing NaN
plot for [name in "scan projection kd-tree orthotree-compressed cells cells-halves"] \
  table using "d":(of(name, column("tested") / column("found"))) title name
