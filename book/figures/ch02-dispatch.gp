# The geometry by pointer, by flag and by copy, in two loops.
height = 2.3
load "book/figures/style.gp"
table = data . "/ch02-dispatch.tsv"
set style data histogram
set style histogram clustered gap 1.2
set boxwidth 0.9 relative
set logscale y
set yrange [0.1:100]
set xrange [-0.6:2.6]
set ylabel "ns a pair"
set key top center horizontal
plot table using 2:xtic(1) title "standard" lt 1 fillstyle solid 0.75, \
     "" using 5 title "wraparound" lt 2 fillstyle solid 0.75, \
     "" using 8 title "standard, lanes" lt 1 fillstyle pattern 4, \
     "" using 11 title "wraparound, lanes" lt 2 fillstyle pattern 4
