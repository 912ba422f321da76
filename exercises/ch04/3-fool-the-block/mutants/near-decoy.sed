# The decoys are nearer than the neighbors.
# expect: may be as near as
# why: The decoy is put where it is sure to be in the block, close by.
s/1\.75, 1\.75/1.35, 1.35/
