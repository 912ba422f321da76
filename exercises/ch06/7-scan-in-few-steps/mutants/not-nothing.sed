# The first sum is the first element.
# expect: Before the first element there is nothing
# why: They think that the first sum is the first element, as in an inclusive scan.
s/to\[0\] = nothing/to[0] = from[0]/
