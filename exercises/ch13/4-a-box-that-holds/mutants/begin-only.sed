# Takes the box of the beginning.
# expect: moves on, and leaves this box
# why: It is the box that one had before anything moved.
s/b = corner\[c\].end\[k\]/b = a/
