# Leaves out the last cell of a stretch.
# expect: Its places end where
s/last + 1\]/last]/;s/places end/&/
