# A cell in the only column is its own neighbor.
# expect: no partner of itself
s/columns == 1/0/; s/rows == 1/0/
