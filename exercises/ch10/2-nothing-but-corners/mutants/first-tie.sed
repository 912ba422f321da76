# Takes the first of those that tie.
# expect: order of their indices
# why: In all searches before this one the points came in the order of their indices.
s/ || (d2 == best2 && j < best)//
