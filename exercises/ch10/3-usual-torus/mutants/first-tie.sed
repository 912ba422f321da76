# Keeps the first of those that tie.
# expect: the other one has the lower place
# why: The cells do not come in the order of the places.
s/ || (d2 == best2 && s < best)//
