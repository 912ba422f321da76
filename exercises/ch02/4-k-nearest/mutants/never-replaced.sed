# Once k points are there, no better one is let in.
# expect: after the first k
s/found == k && d2 >= distances2\[k - 1\]/found == k/
