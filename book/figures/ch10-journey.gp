# Nanoseconds a point of every program, from the first to the last;
# crosses are what the coursework reports.
# alt: Every program from the first to the last, in rows, with its
# nanoseconds a point on a logarithmic axis. From top to bottom they
# fall by four powers of ten and more.
# demo: plot
height = 4.6
load "book/figures/style.gp"
table = data . "/ch10-journey.tsv"
row(name) = 0 + system(sprintf("grep -v '^#' %s | awk -F '\t' 'NR > 1 && $1 == \"%s\" { print NR - 2 }'", table, name))
stats table using "standard" nooutput
rows = STATS_records
unset grid
set grid xtics lc rgb "#dddddd" lw 0.5 dt 1
set logscale x
set format x powers
set xlabel "ns a point" offset 0,0.6
set yrange [rows - 0.5:-0.6]
set ytics scale 0 font ",8"
set bmargin at screen 0.215
set key at screen 0.55,0.01 center bottom horizontal maxrows 3 samplen 2 spacing 1.2
name(k) = system(sprintf("echo %s | tr _ -", strcol(1)))
set print $reported
print "ns\trow"
print sprintf("1.038e6\t%d", row("first"))
print sprintf("7.67e5\t%d", row("triangle"))
print sprintf("1.51e4\t%d", row("cells_lists"))
set print $wrapped
print "ns\trow"
print sprintf("3.15e6\t%d", row("first"))
print sprintf("1.748e6\t%d", row("triangle"))
unset print
plot table using "standard":0:ytic(name(1)) with linespoints lt 1 title "standard, one thread", \
     "" using "standard_all":0 with points lt 1 pt 6 ps 0.75 title "standard, all threads", \
     $reported using 1:2 with points pt 2 ps 0.9 lc rgb "#14447c" title "standard, coursework", \
     table using "wraparound":0 with linespoints lt 2 title "wraparound, one thread", \
     "" using "wraparound_all":0 with points lt 2 pt 4 ps 0.75 title "wraparound, all threads", \
     $wrapped using 1:2 with points pt 1 ps 1.1 lc rgb "#c4511a" title "wraparound, coursework", \
     $reported using 1:2 with points pt 2 ps 0.9 lc rgb "#14447c" notitle
