# Doubles the reach.
# expect: An index
s|reach >= count / 2|2 * reach + 1 >= count|
