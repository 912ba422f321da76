# Takes the first of those that tie.
# expect: lists are in no order
# why: In chapter 4 the points of a cell were in the order of their indices.
s/ || (d2 == best.d2 && j < best.nearest)//
