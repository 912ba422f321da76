# Makes the lower right half only.
# expect: up to all four sides
# why: One quarter is drawn, and how it closes is forgotten.
s/quarter < 4/quarter < 2/
