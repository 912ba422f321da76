# The first offset is not multiplied.
# expect: is multiplied as x is
# why: They multiply out in the head.
s/second.factor \* first.offset/first.offset/
