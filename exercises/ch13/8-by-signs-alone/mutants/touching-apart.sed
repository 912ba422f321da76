# Has an edge separate what touches it.
# expect: there is none
# why: Not inside is read as outside.
s/turn_of(k, NEXT\[k\], 3) < 0 && turn_of(k, NEXT\[k\], 4) < 0/turn_of(k, NEXT[k], 3) <= 0 \&\& turn_of(k, NEXT[k], 4) <= 0/
