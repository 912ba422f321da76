# Throws away what lies on a side.
# expect: Only what is strictly inside
# why: "Not to the right" and "to the left" are the same to them.
s/s].a \* x + side\[s\].b \* y > side/s].a * x + side[s].b * y >= side/
