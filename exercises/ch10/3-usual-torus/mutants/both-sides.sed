# Where the number of cells is even, the last one comes twice.
# expect: in the same cell
# why: Loops from minus half to plus half are one too long for even numbers.
s/c < box.columns; c++/c < box.columns + 1 - box.columns % 2; c++/
