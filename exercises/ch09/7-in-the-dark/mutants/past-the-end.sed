# Takes the last group whole.
# expect: An index
s/next + k <= n/next < n/
