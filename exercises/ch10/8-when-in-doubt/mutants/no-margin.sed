# Takes the hull as it is.
# expect: both are equally far
# why: The furthest point is a corner, says the theorem, and it does not speak of rounding.
s/0x1p-20 \* hypot/0x1p-90 * hypot/
