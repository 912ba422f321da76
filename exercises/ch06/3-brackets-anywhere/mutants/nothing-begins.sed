# No elements begin a segment.
# expect: no segment begins
s/begins = false/begins = true/
