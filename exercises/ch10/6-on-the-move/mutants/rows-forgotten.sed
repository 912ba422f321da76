# Looks at x only.
# expect: they have left long ago
# why: One of two lines that look alike.
s/has_strayed(y, cell \/ box.columns)/0/
