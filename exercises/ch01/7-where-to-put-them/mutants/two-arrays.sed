# All x, then all y.
# expect: fetches two lines for each
# why: It is the layout of the book.
s/return line \* LINE.*/return (axis * ((size_t)n + 3) \/ 4 * 4 + i) * sizeof(double) + 0 * line;/
