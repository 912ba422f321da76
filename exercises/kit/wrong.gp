# Draws a wrong answer: wrong.tsv has the points, the pair that was
# found, the right one, and the borders of cells, in blocks. The caller sets data and output.
set terminal pngcairo size 900,900 fontscale 1.1 background "white"
set output output
set datafile separator tab
set size ratio -1
set border 3
set tics nomirror
set key outside top center horizontal
stats data index 0 nooutput
plot data index 3 using 1:2 with lines lw 1 lc rgb "#bbccdd" notitle, \
     data index 0 using 1:2 with points pt 7 ps (STATS_records > 1000 ? 0.4 : 0.9) \
       lc rgb "#999999" title "points", \
     data index 2 using 1:2 with linespoints pt 6 ps 2.4 lw 3 \
       lc rgb "#14447c" title "right", \
     data index 1 using 1:2 with linespoints pt 4 ps 2.4 lw 3 dt (8,4) \
       lc rgb "#c4511a" title "found"
