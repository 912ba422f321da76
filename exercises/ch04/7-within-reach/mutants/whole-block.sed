# The other half of the block is searched, too.
# expect: found from both sides
# why: It is the safe thing to do, and the text recommends it, as a first step.
s/{1, 0}, {-1, 1}, {0, 1}, {1, 1}}/{1, 0}, {-1, 1}, {-1, 0}, {1, -1}}/; s/(row + steps/(row + rows + steps/
