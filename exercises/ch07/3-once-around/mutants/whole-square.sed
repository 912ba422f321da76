# Also what is inside the ring is written.
# expect: larger of its two numbers
# why: The search of chapter 4 looked at blocks.
s|dx += whole ? 1 : 2 \* far|dx++|
s|cells\[n++\] =|if (n < 8 * k \|\| k == 0) cells[n++] =|
