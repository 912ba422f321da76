# A border as near as the best one is taken to be far enough.
# expect: just as near as the best
# why: With ">=" the search ends a little earlier, and only a tie on a border knows.
s/gap \* gap > best/gap * gap >= best/
