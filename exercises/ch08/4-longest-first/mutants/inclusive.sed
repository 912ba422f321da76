# Begins each length where it ends.
# expect: An index runs past the end
# why: Ends in place of beginnings, once more.
s/places\[b\] = longer;/places[b] = longer + here;/
