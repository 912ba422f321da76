# Begins each length where it ends.
# expect: An index runs past the end
s/places\[b\] = longer;/places[b] = longer + here;/
