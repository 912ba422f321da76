# dx without its square: to the left of the point, nothing is too far.
# expect: Points to the left
# why: They take a root to compare like with like, and forget that a difference has a sign.
s/dx \* dx >= nearest2/dx >= sqrt(nearest2)/
