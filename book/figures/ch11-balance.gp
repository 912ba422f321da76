# Distances of each leaf of Kuzmin's disc, as threads get them; and how
# busy threads are.
# alt: Left, the distances of the leaves, one after the other: they
# scatter around their mean, a few far above it. Right, the
# share of the time in which threads work, over their number, for four
# kinds of points: close to 1 for few threads, and falling slowly.
height = 2.4
load "book/figures/style.gp"
table = data . "/ch11-balance.tsv"
leaf(name) = name[1:5] eq "leaf_" ? real(name[6:*]) : NaN
set datafile missing NaN
set multiplot layout 1,2
set xlabel "leaf"
set ylabel "distances of a leaf, in thousands"
set yrange [0:*]
unset key
plot table using (leaf(strcol(1))):(column("distances")/1000) with points lt 1 pt 7 ps 0.3
set xlabel "threads"
set ylabel "share of the time at work"
set logscale x 2
set xrange [1.7:75]
set yrange [0.5:1.02]
set xtics (2,4,8,16,32,64)
set key bottom left
# The first is taken for the head of a table.
array T[7] = [1,2,4,8,16,32,64]
word_of(k) = word("one two four eight sixteen thirty_two sixty_four", k)
busy(name, k) = system(sprintf("awk -F'\\t' '/^#/{next} !h{for(i=1;i<=NF;i++)c[$i]=i;h=1} $1==\"shared_%s\"{print $c[\"%s\"]}' %s", name, word_of(k), table))
names = "uniform kuzmin towns circle"
plot for [j=1:4] T using (T[$1]):(real(busy(word(names, j), int($1)))) \
     with linespoints lt j ps 0.6 title word(names, j)
unset multiplot
