# A point on a border is taken to be in the cell that ends there.
# expect: belongs to the cell that begins
# why: A point at 1.0 is drawn on the line, and they count it to the cell on its left.
s/{0\.9, 2\.1, 0\.9, 2\.1}/{1, 2.2, 1, 2.2}/
