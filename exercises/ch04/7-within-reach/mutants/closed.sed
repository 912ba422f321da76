# A pair exactly r apart is taken.
# expect: exactly r apart
# why: "Within" is read with an equals sign.
s/measure(i, j) < r \* r/measure(i, j) <= r * r/
