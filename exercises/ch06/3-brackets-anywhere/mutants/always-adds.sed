# The total never starts again.
# expect: What was before does not count
s/right.begins ? right.total : //
