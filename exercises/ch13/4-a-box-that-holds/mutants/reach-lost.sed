# Trusts the difference in double precision.
# expect: The reach is lost
# why: Double precision is so much finer that its rounding is forgotten.
s/nextafter(x - reach, -INFINITY)/x - reach/
