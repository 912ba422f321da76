# A border as near as the best one is taken to be far enough.
# expect: just as near as the best
s/gap \* gap > best/gap * gap >= best/
