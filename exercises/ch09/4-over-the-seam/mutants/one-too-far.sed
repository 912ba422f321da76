# Takes a column too many.
# expect: ends where the first cell behind it begins
s/last + 1\]/last + 2]/
