# book/data/ch01-speeds.tsv
# expect: chapters/ch01-near.md:22: the head of book/data/ch01-speeds.tsv has no line "# date: ..."
/^# date/d
