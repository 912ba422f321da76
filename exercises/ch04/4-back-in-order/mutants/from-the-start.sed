# The search for a stranger begins at the first slot every time.
# expect: begin where the last one was found
# why: It is simple and right, and on small cells the search is not noticed.
s/while (cell_of(home\[c\]) == c)/home[c] = start[c]; &/
