# Where threads tie, the one that comes first wins.
# expect: the thread that came first or last
# why: With a static schedule and luck, threads come in order of their rows.
# points: 8
s/better(mine, best)/mine.distance2 < best.distance2/
