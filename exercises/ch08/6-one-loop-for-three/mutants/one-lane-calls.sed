# Calls next_cell for one lane at a time.
# expect: are in one call
# why: A lane that runs out calls for its next cell where the fact is noticed, in the loop over lanes.
/^        next_cell(waiting.n,/{
N
s/.*/        for (uint32_t a = 0; a < waiting.n; a++)\n            next_cell(1, waiting.task + a, waiting.visited + a, waiting.cell + a);/
}
