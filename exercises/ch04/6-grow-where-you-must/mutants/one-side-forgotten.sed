# The upper border is never looked at.
# expect: on all four
# why: Four cases, copied and changed, and one of them was not.
s/side < SIDES/side < ABOVE/
