# high itself is left out.
# expect: itself belongs to the last bin
# why: A half-open interval is a good habit, and the last bin is the exception to it.
s/value <= high/value < high/
