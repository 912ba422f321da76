# Takes steps with a common divisor, too.
# expect: steps of the same direction are one side
# why: All small steps look like different ones.
s/common_divisor(a, b) > 1/common_divisor(a, b) > 1000/
