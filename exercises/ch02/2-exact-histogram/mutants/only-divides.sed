# The quotient is taken at its word.
# expect: was rounded
# why: It is the usual way, in every language, and in a picture it is good enough.
s/if (value < edge(low, high, bins, b))/if (b < 0)/
s/b < bins - 1 && value >= edge(low, high, bins, b + 1)/b < 0/
