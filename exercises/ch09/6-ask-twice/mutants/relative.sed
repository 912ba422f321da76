# Takes a part of the distance for the bound.
# expect: and at any distance
# why: Errors of floating point are relative, they have learned.
s/sqrt(least2) + 0x1p-22/sqrt(least2) * (1 + 0x1p-19)/
