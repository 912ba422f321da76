# Begins with the cells around the one who asks.
# expect: First to the cells that reach furthest
# why: That is where searches for the nearest point begin.
s/uint32_t middle = .*/uint32_t middle = x;/
s/uint32_t top = .*/uint32_t top = y;/
