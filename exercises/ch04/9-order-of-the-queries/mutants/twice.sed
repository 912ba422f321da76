# Each query is answered twice.
# expect: Each query is answered once
# why: The old loop was left standing before the new one.
s/struct query \*sorted = sort_queries(n, x, y);/for (uint32_t q = 0; q < n; q++) nearest[q] = find_nearest(x[q], y[q]);\
&/
