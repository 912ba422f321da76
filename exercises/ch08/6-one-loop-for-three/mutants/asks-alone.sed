# Asks for one lane at a time.
# expect: ask together
# why: A lane that runs out calls for its next cell where the fact is noticed, in the loop over lanes.
s/^        next_cell(asking.n, .*/        for (uint32_t a = 0; a < asking.n; a++)\n            next_cell(1, asking.task + a, asking.visited + a, asking.cell + a);/
