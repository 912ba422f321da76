# Doubles the reach.
# expect: An index
# why: 2 * reach + 1 is the width of a block, and reach was never large.
s|reach >= count / 2|2 * reach + 1 >= count|
