# Takes the bits of the keys as they were at first.
# expect: go on with what the one before it left
# why: The bits are computed before the loop, since they do not seem to change.
s/for (int k = 0;/struct vector old = keys;\n    &/
s/bit(keys, k)/bit(old, k)/
