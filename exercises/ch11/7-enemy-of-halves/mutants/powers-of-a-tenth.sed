# Powers of a tenth.
# expect: Two are the same
# why: Ten is the more usual number.
s/power \*= 0.49/power *= 0.1/
