# What counting by groups takes for a point, by how many points lose;
# the line is fitted to groups of 64 in the first cache. Open: points of
# all kinds in their own cells, many more of them.
# alt: Nanoseconds a point over the losers a point. For groups of 64
# lanes the dots follow a line that rises gently; groups of 8 are far
# above it, groups of 512 a little. Uniform and clustered points are
# highest, although hardly any of them lose.
height = 3.1
load "book/figures/style.gp"
table = data . "/ch05-bill.tsv"
stats table using (strcol(1) eq "point" ? column("predicted") : NaN) nooutput
a = STATS_max
stats table using (strcol(1) eq "loser" ? column("predicted") : NaN) nooutput
b = STATS_max
set xlabel "losers a point"
set ylabel "ns a point"
set xrange [-0.03:1.03]
set yrange [0:*]
set key outside top center horizontal maxrows 2 samplen 1
of(kind, lanes) = strcol(1)[1:strlen(kind)] eq kind && column("lanes") == lanes ? column("groups") : NaN
mine(kind) = strcol(1)[1:strlen(kind)] eq kind ? column("groups") : NaN
plot table using "losers":(of("random", 8)) with points lt 2 title "8 lanes", \
     "" using "losers":(of("random", 64)) with points lt 1 title "64 lanes", \
     "" using "losers":(of("random", 512)) with points lt 3 title "512 lanes", \
     a + b * x with lines lt 1 lw 0.9 notitle, \
     "" using "losers":(mine("uniform")) with points pt 6 ps 0.8 lc rgb "black" title "uniform", \
     "" using "losers":(mine("clustered")) with points pt 8 ps 0.9 lc rgb "black" title "clustered", \
     "" using "losers":(mine("two_clusters")) with points pt 4 ps 0.8 lc rgb "black" title "two clusters", \
     "" using "losers":(mine("kuzmin")) with points pt 12 ps 0.9 lc rgb "black" title "kuzmin", \
     "" using "losers":(mine("equal")) with points pt 10 ps 0.9 lc rgb "black" title "equal"
