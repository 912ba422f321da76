# The first sum is the first element.
# expect: Before the first element there is nothing
s/to\[0\] = nothing/to[0] = from[0]/
