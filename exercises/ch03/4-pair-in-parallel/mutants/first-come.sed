# Where threads tie, the one that comes first wins.
# expect: whichever thread came
s/better(mine, best)/mine.distance2 < best.distance2/
