# One row too few behind: the last pair wraps around.
# expect: no pair at all
# why: Counting from the end has two places to be off by one, the number of rows behind and the number of pairs behind.
s/triangle(n - 1) - 1 - number/triangle(n - 1) - 2 - number/
/while (triangle(t)/,/t++;/d
