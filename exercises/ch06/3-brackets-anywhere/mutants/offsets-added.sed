# The first offset is not multiplied.
# expect: is multiplied as x is
s/second.factor \* first.offset/first.offset/
