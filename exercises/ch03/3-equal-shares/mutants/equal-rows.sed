# Every thread gets as many rows, as a static schedule does.
# expect: as many rows
# why: It is what the static schedule does; they wrote it out by hand.
s/while (done \* threads < all \* (t + 1))/while (all > 0 \&\& i < (uint64_t)n * (t + 1) \/ threads)/
