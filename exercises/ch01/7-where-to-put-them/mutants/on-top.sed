# The y stand in the next vector of x.
# expect: Two numbers stand in one place
# why: A line of 32 bytes was in their minds.
s/line \* LINE/line * VECTOR/
