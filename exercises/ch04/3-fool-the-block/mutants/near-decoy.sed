# The decoys are nearer than the neighbors.
# expect: may be as near as
s/1\.75, 1\.75/1.35, 1.35/
