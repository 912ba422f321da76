# Of several cells with a tie, the first one wins.
# expect: whichever cell was looked at first
s|return a.nearest < b.nearest ? a : b|return a|
