# Thinks of one error, not of two.
# expect: Both may be wrong, in opposite directions
# why: They bound the error of one distance, and two distances are compared.
s/0x1p-22/0x1p-23/
