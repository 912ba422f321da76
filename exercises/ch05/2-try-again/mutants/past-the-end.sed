# The last group is taken for a full one.
# expect: runs past the end
s/lanes = n - i < LANES ? n - i : LANES/lanes = LANES/
