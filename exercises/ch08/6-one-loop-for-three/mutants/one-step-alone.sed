# Lets one task measure at a time.
# expect: all tasks that have work left
# why: A loop over lanes with a measure in it.
s/^        measure(lanes.n, lanes.task, lanes.place);/        for (uint32_t l = 0; l < lanes.n; l++)\n            measure(1, lanes.task + l, lanes.place + l);/
