# book/data/ch01-speeds.tsv
# expect: book/data/ch01-speeds.tsv:7: 5 cells, but 4 columns
7s/$/	5/
