# Asks everybody again.
# expect: Everybody was asked
# why: It is right, and makes the filter superfluous.
s/scratch\[s\] > limit \* limit/scratch[s] > 2/
