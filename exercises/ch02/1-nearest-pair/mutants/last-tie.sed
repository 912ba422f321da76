# <= keeps the last of several equal pairs.
# expect: keeps the last of them
# why: With "<=" the loop seems to need no special beginning.
s/d2 < best/d2 <= best/
