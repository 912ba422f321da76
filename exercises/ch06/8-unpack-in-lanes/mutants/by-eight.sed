# Moves on in the survivors by one for each flag, set or not.
# expect: Survivors were left out
# why: It is what to does, and the two look alike.
s/from += set;/from++;/
