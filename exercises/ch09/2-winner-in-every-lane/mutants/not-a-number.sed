# Tests whether it is not further.
# expect: Its lane had NAN later
# why: "Not greater" is "less or equal", for numbers.
s/(d2 < best->distance2\[l\])/!(d2 >= best->distance2[l])/
