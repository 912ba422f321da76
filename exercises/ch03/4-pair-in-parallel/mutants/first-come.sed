# Where threads tie, the one that comes first wins.
# expect: whichever thread came
# why: With a static schedule and luck, threads come in order of their rows.
s/better(mine, best)/mine.distance2 < best.distance2/
