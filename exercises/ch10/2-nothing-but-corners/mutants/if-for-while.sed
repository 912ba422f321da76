# Takes one point away, no more.
# expect: the one before it may have to go
# why: One point that has gone is what the drawing in most books shows.
s/while (count > low/if (count > low/
