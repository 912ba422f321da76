# Begins above 1.
# expect: numbers from 0 to 1
# why: Two to the k, and divided by n at the end.
s/power \*= 0.49/power *= 2/
