# The upper border is never looked at.
# expect: on all four
s/side < SIDES/side < ABOVE/
