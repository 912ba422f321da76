# For each slot, the points behind it are searched for one that belongs there.
# expect: square of n
# why: They know one sort in place by heart.
/uint32_t c = /,/exchange(s, home/c\
uint32_t t = s + 1; while (cell_of(t) != k) t++; exchange(s, t);
