# Takes a tenth of the box for the margin.
# expect: Is the margin too wide
# why: To be on the safe side.
s/0x1p-20/0.1/
