# Leaves out the last point of a leaf.
# expect: with all their points
# why: The end is taken for the last.
s/s < (leaf + 1) \* n \/ tree->leaves; s++/s + (leaf % 2) < (leaf + 1) * n \/ tree->leaves; s++/
