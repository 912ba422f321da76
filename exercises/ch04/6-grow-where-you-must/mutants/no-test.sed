# The first one found ends the search.
# expect: ended when somebody was found
s/gap \* gap > best.nearest2/best.nearest2 < INFINITY/
