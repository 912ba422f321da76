# The point that came in exchange is not looked at.
# expect: look again
# why: After an exchange they go on to the next slot, as one does in a loop.
s/while (cell_of(s) != k)/if (cell_of(s) != k)/
