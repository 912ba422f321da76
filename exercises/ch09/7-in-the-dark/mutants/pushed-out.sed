# Forgets who has to leave.
# expect: kept more than once
/^static void insert/,/^}/s/exchange(&kept\[i\], &key)/kept[i] = least(kept[i], key)/
