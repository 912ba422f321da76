# No steps make 0 of everything.
# expect: x is lost
# why: Zero is the neutral element of sums, and they had only sums before.
s/factor = 1, /factor = 0, /
