# Of several cells with a tie, the first one wins.
# expect: whichever cell was looked at first
# why: look() answers ties inside of a cell, and they do not think of two cells.
s|return a.nearest < b.nearest ? a : b|return a|
