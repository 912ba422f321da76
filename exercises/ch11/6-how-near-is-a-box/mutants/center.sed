# Measures to the middle of the box.
# expect: nearer
# why: A box has a middle.
s/double direct = .*/double direct = fabs((low + high) \/ 2 - x);/
