# No elements begin a segment.
# expect: no segment begins
# why: The starter says so, and a segment has to begin somewhere, they feel.
s/begins = false/begins = true/
