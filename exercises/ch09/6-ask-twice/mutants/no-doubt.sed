# Computes only the smallest again.
# expect: Both may be wrong, in opposite directions
# why: The smallest in single precision is the smallest, nearly always.
s/ + 0x1p-22//
s/double limit = /double limit = (1 + 0x1p-30) * /
