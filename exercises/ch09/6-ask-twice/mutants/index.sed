# Gives an index for a place.
# expect: not the distance of that point
s/exact(s)/exact(j)/
