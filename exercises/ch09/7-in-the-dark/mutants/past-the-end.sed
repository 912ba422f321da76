# Takes the last group whole.
# expect: An index
# why: The number of keys was a multiple of eight.
s/next + k <= n/next < n/
