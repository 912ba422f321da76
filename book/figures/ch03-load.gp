# The share of the pairs that each of ten threads gets under three static
# schedules.
# alt: For ten threads the share of all pairs under three schedules. One
# block each falls from a fifth to almost nothing; four blocks each
# falls gently; row by row is level at a tenth.
height = 2.2
load "book/figures/style.gp"
table = data . "/ch03-load.tsv"
set xlabel "thread"
set ylabel "share of all pairs, percent"
set yrange [0:22]
set key top right noreverse Right
set style data histograms
set style histogram clustered gap 1
set boxwidth 0.95 relative
set xtics scale 0
plot table using (100*column("blocks")):xtic(2) title "one block each" \
       lt 1 fs solid 0.7, \
     "" using (100*column("quarters")) title "four blocks each" \
       lt 2 fs pattern 4, \
     "" using (100*column("singles")) title "row by row" \
       lt 3 fs empty
