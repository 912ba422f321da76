# Finds the point that asks.
# expect: the point that asks
s/(j != self)/1/
