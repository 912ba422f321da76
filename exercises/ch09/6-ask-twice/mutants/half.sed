# Thinks of one error, not of two.
# expect: Both may be wrong, in opposite directions
s/0x1p-22/0x1p-23/
