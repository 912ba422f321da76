# Goes on beyond the last corner.
# expect: After the last corner
# why: The remainder is forgotten in one of the two places.
s/height(i, (k + 1) % n)/height(i, k + 1)/
