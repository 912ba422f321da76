# The other half of the block is searched, too.
# expect: met from both sides
s/{1, 0}, {-1, 1}, {0, 1}, {1, 1}}/{1, 0}, {-1, 1}, {-1, 0}, {1, -1}}/; s/(row + steps/(row + rows + steps/
