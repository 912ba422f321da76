# The first one found ends the search.
# expect: ended when a point was found
# why: A point has been found, and the search of the text seems to be over.
s/gap \* gap > best.nearest2/best.nearest2 < INFINITY/
