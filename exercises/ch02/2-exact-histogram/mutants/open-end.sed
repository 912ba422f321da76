# high itself is left out.
# expect: itself belongs to the last bin
s/value <= high/value < high/
