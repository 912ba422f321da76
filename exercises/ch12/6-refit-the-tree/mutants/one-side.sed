# Hands up the left box only.
# expect: both nodes below it
# why: The right one was used already.
s/left.high\[axis\] = fmax(left.high\[axis\], right.high\[axis\]);/(void)axis;/
