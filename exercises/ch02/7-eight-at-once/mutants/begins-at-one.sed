# The bests begin with 2, the largest square in the unit square.
# expect: No point is that near
# why: In their pictures all points lie in the unit square.
s/best\[l\] = INFINITY/best[l] = 2/
