# The last row, which has no pairs, is left out.
# expect: the last row
s/first\[threads\] = n;/first[threads] = n - 1;/
