# Time a point over the number of points, building included, one thread;
# left with the points as they come, right in strips. Open: not run,
# expected.
# alt: Nanoseconds a point over the number of points, both axes
# logarithmic, for six programs, with uniform, clustered and Kuzmin
# points. Row spans are lowest for the first two; for Kuzmin's points
# the grid's times grow far beyond those of the trees.
# demo: apart
height = 5.9
load "book/figures/style.gp"
table = data . "/ch09-peers.tsv"
programs = "row-spans spiral nanoflann CGAL ANN FLANN"
# What is ours has lines and full marks; the libraries, which lie close
# together, have thin lines and open marks of different shapes.
set linetype 1 lc rgb "#14447c" lw 2.2 dt 1     pt 7  ps 0.6
set linetype 2 lc rgb "#8a2a6a" lw 1.4 dt (8,3) pt 13 ps 0.7
set linetype 3 lc rgb "#c4511a" lw 0.8 dt 1     pt 4  ps 0.75
set linetype 4 lc rgb "#2f7d4f" lw 0.8 dt 1     pt 8  ps 0.85
set linetype 5 lc rgb "#000000" lw 0.8 dt (2,3) pt 2  ps 0.7
set linetype 6 lc rgb "#777777" lw 0.8 dt 1     pt 6  ps 0.75
cell(program, kind, order, what) = strcol("program") eq program && \
  strcol("kind") eq kind && strcol("order") eq order ? column(what) : NaN
set datafile missing NaN
set logscale xy
set xrange [700:*]
unset key
set multiplot layout 3,2 margins 0.11,0.985,0.15,0.955 spacing 0.035,0.035
do for [kind in "uniform clustered kuzmin"] {
  do for [order in "unordered ordered"] {
    left = order eq "unordered"
    set title (kind ne "uniform" ? "" : left ? "points as they come" : "points in strips") offset 0,-0.6
    set label 1 (kind eq "kuzmin" ? "Kuzmin" : kind) at graph 0.04, graph 0.91 front
    set ylabel (left ? "ns a point" : "") offset -0.2
    set format y (left ? powers : "")
    set xlabel (kind eq "kuzmin" ? "points" : "")
    if (kind eq "kuzmin") {
      set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6, "10^7" 1e7)
    } else {
      set xtics ("" 1e3, "" 1e4, "" 1e5, "" 1e6, "" 1e7)
    }
    set yrange [10:(kind eq "kuzmin" ? 1.5e7 : 1.5e4)]
    plot for [k=1:6] table using "n":(cell(word(programs, k), kind, order, "total")) \
           with linespoints lt k, \
         for [k=1:2] "" using "n":(kind eq "kuzmin" ? cell(word(programs, k), kind, order, "expected") : 0) \
           with points pt (k == 1 ? 4 : 12) ps 1.1 lw 2 lc rgb (k == 1 ? "#14447c" : "#8a2a6a")
  }
}
# One key for all six, under them.
set margins screen 0, screen 1, screen 0, screen 0.07
unset title
unset label 1
unset xlabel
unset ylabel
unset border
unset tics
unset logscale
set key center bottom horizontal maxrows 2 samplen 3
plot [0:1] [0:1] for [k=1:6] 2 with linespoints lt k title word(programs, k)
unset multiplot
