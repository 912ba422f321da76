# The second pair is two rows away, and the blocks are empty.
# expect: it needs a decoy
# why: Their four points are far from each other, so that all blocks are empty, and the search goes on and finds the truth.
s/1\.75, 1\.75/2.25, 2.25/
