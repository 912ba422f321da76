# Forgets who has to leave.
# expect: kept more than once
# why: The smaller one is put in its place, and who stood there is not passed on.
/^static void insert/,/^}/s/exchange(&kept\[i\], &key)/kept[i] = least(kept[i], key)/
