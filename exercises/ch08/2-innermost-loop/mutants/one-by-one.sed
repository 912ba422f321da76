# Takes one task at a time.
# expect: leaves the machine idle
s/^ *measure(strip->lanes, strip->task, strip->place);/        for (uint32_t l = 0; l < strip->lanes; l++)\n            measure(1, strip->task + l, strip->place + l);/
