# Asks whether it is not further.
# expect: Its lane met NAN later
s/(d2 < best->distance2\[l\])/!(d2 >= best->distance2[l])/
