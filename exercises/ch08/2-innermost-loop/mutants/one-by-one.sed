# Takes one task at a time.
# expect: leaves the machine idle
# why: A loop over tasks is the natural program, and it needs no pack.
s/^ *measure(strip->lanes, strip->task, strip->place);/        for (uint32_t l = 0; l < strip->lanes; l++)\n            measure(1, strip->task + l, strip->place + l);/
