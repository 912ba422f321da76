# Takes a margin that is far too narrow.
# expect: both are equally far
# why: A rounding is 2^-53 of a number, so 2^-40 looks like plenty; but what the margin gains is its square.
# points: 6
s/0x1p-20 \* hypot/0x1p-40 * hypot/
