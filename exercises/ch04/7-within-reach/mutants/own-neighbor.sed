# A cell in the only column is its own neighbor.
# expect: no partner of itself
# why: With one column, one step to the right is a step in place, and the remainder hides it.
s/columns == 1/0/; s/rows == 1/0/
