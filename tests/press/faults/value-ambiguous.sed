# book/data/ch01-speeds.tsv
# expect: chapters/ch01-near.md:20: ch01.first.ns could be a cell of book/data/ch01-speeds.tsv or of book/data/ch01-speeds.tsv
/^second/s//first/
