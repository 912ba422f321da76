# Gives an index for a place.
# expect: not the distance of that point
# why: exact() takes a place, and an index is a number, too.
s/exact(s)/exact(j)/
