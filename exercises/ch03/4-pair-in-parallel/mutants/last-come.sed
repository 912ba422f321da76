# Where threads tie, the one that comes last wins.
# expect: whichever thread came
s/better(mine, best)/mine.distance2 <= best.distance2/
