# Time a point over the number of points, building included, one thread;
# above with the points as they come, below in strips. Crosses: not run,
# expected.
# demo: apart
height = 4.7
load "book/figures/style.gp"
table = data . "/ch09-peers.tsv"
programs = "row-spans spiral nanoflann CGAL ANN FLANN"
looks = "1 6 2 3 4 5"
cell(program, kind, order, what) = strcol("program") eq program && \
  strcol("kind") eq kind && strcol("order") eq order ? column(what) : NaN
set datafile missing NaN
set logscale xy
set xrange [700:14000000]
set xtics ("10^3" 1e3, "10^4" 1e4, "10^5" 1e5, "10^6" 1e6, "10^7" 1e7)
set format y "10^{%T}"
unset key
set multiplot layout 2,3 margins 0.1,0.985,0.16,0.95 spacing 0.07,0.11
do for [order in "coming ordered"] {
  do for [kind in "uniform clustered kuzmin"] {
    set title (kind eq "kuzmin" ? "Kuzmin" : kind) . (order eq "coming" ? "" : ", in strips")
    set ylabel (kind eq "uniform" ? "ns a point" : "") offset 0.5
    set xlabel (order eq "ordered" ? "points" : "")
    set yrange [10:(kind eq "kuzmin" ? 1e7 : 1e4)]
    plot for [k=1:6] table using "n":(cell(word(programs, k), kind, order, "total")) \
           with linespoints lt word(looks, k) + 0, \
         for [k=1:2] "" using "n":(kind eq "kuzmin" ? cell(word(programs, k), kind, order, "expected") : 0) \
           with points pt (k == 1 ? 2 : 1) ps 1 lc rgb "#222222"
  }
}
# One key for all six, under them.
set margins screen 0, screen 1, screen 0, screen 0.08
unset title
unset xlabel
unset ylabel
unset border
unset tics
unset logscale
set key center bottom horizontal maxrows 1 samplen 2.2
plot [0:1] [0:1] for [k=1:6] 2 with linespoints lt word(looks, k) + 0 title word(programs, k)
unset multiplot
