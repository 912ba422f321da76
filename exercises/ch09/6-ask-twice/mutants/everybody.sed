# Asks everybody again.
# expect: Everybody was asked
s/scratch\[s\] > limit \* limit/scratch[s] > 2/
