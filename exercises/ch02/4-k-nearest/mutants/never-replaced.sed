# Once k points are there, no better one is let in.
# expect: after the first k
# why: The branch for a full hand was written as "nothing to do", to be completed later.
s/found == k && d2 >= distances2\[k - 1\]/found == k/
