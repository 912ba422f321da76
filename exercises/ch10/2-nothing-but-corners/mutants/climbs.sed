# Stops at the first corner that is nearer than the one before.
# expect: distances may fall and rise again
# why: On a circle, or from far away, it is right, and it seems a pity to ask everybody.
s/^            best = j;/            best = j; } else if (d2 < best2) { break;/
s/^            best2 = d2;/&/
s/^        if (d2 > best2 ||/        if (d2 >= best2 ||/
