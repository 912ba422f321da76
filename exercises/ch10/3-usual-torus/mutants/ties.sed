# Leaves out cells that are just as far.
# expect: with a bound that is just equal
# why: In the search for a distance alone it would be right.
s/dx \* dx + dy \* dy < best2/dx * dx + dy * dy <= best2/
