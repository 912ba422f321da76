# A point on a border is taken to be in the cell that ends there.
# expect: belongs to the cell that begins
s/{0\.9, 2\.1, 0\.9, 2\.1}/{1, 2.2, 1, 2.2}/
