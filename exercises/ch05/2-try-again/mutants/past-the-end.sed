# The last group is taken for a full one.
# expect: runs past the end
# why: A number of points that is a multiple of 64 is the first thing that one tries.
s/n - i < LANES ? n - i : LANES/LANES/
