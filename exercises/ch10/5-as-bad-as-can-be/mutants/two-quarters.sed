# Makes the lower right half only.
# expect: in all four quarters
# why: One quarter is drawn, and how it closes is forgotten.
s/quarter < 4/quarter < 2/
