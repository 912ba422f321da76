# No steps make 0 of everything.
# expect: x is lost
s/factor = 1, /factor = 0, /
