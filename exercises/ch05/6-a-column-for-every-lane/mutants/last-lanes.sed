# All lanes work in every step.
# expect: runs past the end
# why: The number of points was a multiple of 16.
s/i < n && lanes < LANES/lanes < LANES/
