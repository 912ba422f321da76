# Of several cells with a tie, the first one wins.
# expect: whichever cell was looked at first
# why: The given function answers ties inside of a cell, and they take that for all.
s/return a.nearest < b.nearest ? a : b/return a/
