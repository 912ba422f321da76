# All lanes work in every step.
# expect: runs past the end
s/i < n && lanes < LANES/lanes < LANES/
