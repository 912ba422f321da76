# The second pair is two rows away, and the blocks are empty.
# expect: it needs a decoy
s/1\.75, 1\.75/2.25, 2.25/
