# Computes all again.
# expect: All were computed
# why: It is right, and makes the filter superfluous.
s/scratch\[s\] > limit \* limit/scratch[s] > 2/
