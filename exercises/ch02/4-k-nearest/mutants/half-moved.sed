# The distances move up, the indices stay where they are.
# expect: move both
s/neighbors\[place\] = neighbors\[place - 1\];//
