# The last row, which has no pairs, is left out.
# expect: the last row
# why: The loop ends with the last pair, and the last row has none.
s/first\[threads\] = n;/first[threads] = n - 1;/
