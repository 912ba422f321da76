# How many times faster than the serial naive search each version is, in
# both geometries, and beside it what the coursework reports.
# alt: For each version, in both geometries, how many times faster than
# the naive search it is, on a logarithmic axis, as points for one
# thread and for all processors, with the ratios of the coursework as
# open marks. They rise from left to right.
height = 2.9
load "book/figures/style.gp"
table = data . "/ch03-speed.tsv"
$coursework << END
version	standard	wraparound	standard_parallel	wraparound_parallel
0	103.8	315.0	12.91	38.73
1	76.70	174.8	10.98	23.48
END
set multiplot layout 1,2 margins 0.09,0.95,0.19,0.78 spacing 0.06
set logscale y 2
set yrange [0.5:24]
set xrange [-0.6:4.6]
set xtics ("naive" 0, "triangle" 1, "reduction" 2, "tiles" 3, "half tiles" 4) \
  rotate by -30
of(name, k) = strcol(1)[1:strlen(name)] eq name ? column(k) : NaN

set title "standard"
unset key
set ylabel "times faster than naive on one thread" offset 1.5
stats table using (of("standard_naive", "serial_ns")) nooutput
plot table using 0:(STATS_max / of("standard", "serial_ns")) \
       with points ps 0.9, \
     "" using 0:(STATS_max / of("standard", "parallel_ns")) \
       with points ps 0.9, \
     $coursework using 1:(103.8 / column("standard")) \
       with points pt 6 ps 0.9 lc rgb "black", \
     "" using 1:(103.8 / column("standard_parallel")) \
       with points pt 4 ps 0.9 lc rgb "black"

set title "wraparound"
unset ylabel
set format y ""
set key at screen 0.52,0.99 center top vertical maxrows 2 samplen 1
stats table using (of("wraparound_naive", "serial_ns")) nooutput
plot table using ($0 - 6):(STATS_max / of("wraparound", "serial_ns")) \
       with points ps 0.9 title "one thread", \
     "" using ($0 - 6):(STATS_max / of("wraparound", "parallel_ns")) \
       with points ps 0.9 title "all processors", \
     $coursework using 1:(315.0 / column("wraparound")) \
       with points pt 6 ps 0.9 lc rgb "black" title "coursework, one", \
     "" using 1:(315.0 / column("wraparound_parallel")) \
       with points pt 4 ps 0.9 lc rgb "black" title "coursework, ten"
unset multiplot
