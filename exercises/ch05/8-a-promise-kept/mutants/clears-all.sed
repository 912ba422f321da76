# The whole array is cleared, fresh or not.
# expect: Fresh memory is 0 already
# why: memset is one line, and that it touches cannot be seen.
s/bytes < used ? bytes : used/bytes/
