# Powers of one half.
# expect: This middle was rounded
# why: It is the first thing to try, and right but for the rounding of the middle.
s/power \*= 0.49/power *= 0.5/
