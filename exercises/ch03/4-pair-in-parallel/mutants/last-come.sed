# Where threads tie, the one that comes last wins.
# expect: the thread that came first or last
# why: The same, with "<=" where the threads hand in.
s/better(mine, best)/mine.distance2 <= best.distance2/
