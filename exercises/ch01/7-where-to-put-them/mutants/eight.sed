# Eight x on a line, then eight y on the next.
# expect: fetches two lines for each
# why: A whole line of x seems better than half a line.
s/uint32_t group = VECTOR/uint32_t group = LINE/; s/line \* LINE + axis \* VECTOR/line * 2 * LINE + axis * LINE/
