# Takes a column too many.
# expect: ends where the first cell behind it begins
# why: The same place, with one added twice.
s/last + 1\]/last + 2]/
