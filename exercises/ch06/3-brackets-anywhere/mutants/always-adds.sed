# The total never starts again.
# expect: What was before does not count
# why: It is a sum, and the beginnings are to be dealt with later.
s/right.begins ? right.total : //
