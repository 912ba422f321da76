# Takes the last row unseen.
# expect: was taken unseen
# why: The first row is thought of, the last is the end of the loop.
s/j == block.first_row || j == block.last_row ||/j == block.first_row ||/
