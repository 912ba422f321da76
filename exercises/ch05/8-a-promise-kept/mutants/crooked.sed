# The size is not rounded up.
# expect: What is taken must be rounded up
# why: malloc has always seen to that.
s/(bytes + ALIGNED - 1) \/ ALIGNED \* ALIGNED/bytes/
