# j - i, but the first pair of a row has j = i + 1.
# expect: first pair of its row
s/(j - i - 1)/(j - i)/
