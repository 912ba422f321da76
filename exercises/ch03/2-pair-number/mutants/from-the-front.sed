# One row too few behind: the last pair wraps around.
# expect: no pair at all
s/triangle(n - 1) - 1 - number/triangle(n - 1) - 2 - number/
/while (triangle(t)/,/t++;/d
