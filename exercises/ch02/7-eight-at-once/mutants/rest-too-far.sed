# The last group is taken for a full one.
# expect: runs past the end
# why: The loop that steps by eight is written first, and the tests of their own have full groups only.
s/i + LANES <= from.n/i < from.n/
