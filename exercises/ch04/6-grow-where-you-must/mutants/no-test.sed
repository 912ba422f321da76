# The first one found ends the search.
# expect: ended when somebody was found
# why: Somebody has been found, and the search of the text seems to be over.
s/gap \* gap > best.nearest2/best.nearest2 < INFINITY/
