# A margin of a part in a million.
# expect: wider than what rounding takes away
# why: It holds, and looks small.
s/return nearest <= safe ? nearest : nextafterf(nearest, -INFINITY);/return (float)(safe - 1e-5 * fabs(safe));/
