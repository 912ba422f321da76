# The distances move up, the indices stay where they are.
# expect: move both
# why: Two arrays, one loop, and the second statement is forgotten.
s/neighbors\[place\] = neighbors\[place - 1\];//
