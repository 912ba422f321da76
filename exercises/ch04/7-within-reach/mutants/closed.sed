# A pair exactly r apart is taken.
# expect: exactly r apart
s/measure(i, j) < r \* r/measure(i, j) <= r * r/
