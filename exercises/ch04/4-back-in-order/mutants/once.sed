# The point that came in exchange is not looked at.
# expect: look again
s/while (cell_of(s) != k)/if (cell_of(s) != k)/
