# Takes beginnings for ends.
# expect: in which direction
# why: Left and right are named after the places before the swap, and read after it.
s/if (left.high && !right.high)/if (!left.high \&\& right.high)/
t
s/if (!left.high && right.high)/if (left.high \&\& !right.high)/
