# Leaves out the last cell of a stretch.
# expect: Their places end where
# why: The end of the last cell is the start of the cell behind it, and they take its own start.
s/last + 1\]/last]/;s/places end/&/
