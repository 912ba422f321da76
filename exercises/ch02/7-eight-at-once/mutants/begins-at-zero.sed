# The bests begin with zero.
# expect: larger than all others
# why: An array is cleared by habit, and nothing is nearer than zero.
s/best\[l\] = INFINITY/best[l] = 0/
