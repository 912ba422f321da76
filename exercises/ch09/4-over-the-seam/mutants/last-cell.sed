# Leaves out the last cell of a stretch.
# expect: Their places end where
s/last + 1\]/last]/;s/places end/&/
