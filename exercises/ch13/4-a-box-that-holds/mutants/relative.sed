# Makes a lower side smaller by a factor, also below 0.
# expect: on both sides of 0
# why: Coordinates are positive in one's head.
s/return nearest <= safe ? nearest : nextafterf(nearest, -INFINITY);/return (float)(safe * (1 - 0x1p-22));/
