# <= keeps the last of several equal pairs.
# expect: keeps the last of them
s/d2 < best/d2 <= best/
