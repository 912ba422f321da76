# book/data/ch01-speeds.tsv
# expect: book/data/ch01-speeds.tsv:9: 5 cells, but 4 columns
9s/$/	5/
