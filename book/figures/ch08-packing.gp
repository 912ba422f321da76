# Lanes that the loop over points occupies for each point, over the
# length of the strips: with packing, and if no task were packed away.
# alt: Lanes used for a useful one over the tasks in a strip, both axes
# logarithmic. Packed in each loop the curve falls toward one; never
# packed it rises.
height = 2.1
load "book/figures/style.gp"
table = data . "/ch08-strips.tsv"
set logscale x 2
set logscale y 2
set xlabel "tasks in a strip"
set ylabel "lanes for a point compared"
set xrange [3.5:80000]
set yrange [0.8:*]
set xtics ("4" 4, "16" 16, "64" 64, "256" 256, "1024" 1024, "4096" 4096, "16384" 16384, "65536" 65536)
set key top left
plot table using "length":(column("unpacked") / column("points")) with linespoints lt 2 title "never packed", \
     "" using "length":(column("lanes") / column("points")) with linespoints lt 1 title "packed in each loop"
