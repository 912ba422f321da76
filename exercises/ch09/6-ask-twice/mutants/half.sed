# Thinks of one error, not of two.
# expect: Both may be wrong
s/0x1p-22/0x1p-23/
