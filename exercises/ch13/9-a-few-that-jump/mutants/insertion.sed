# Insertion sort of all.
# expect: Most boxes have kept their order
# why: It is what the chapter does with boxes that move little.
s/^    qsort(room, out, sizeof \*room, compare);/    out = 0;/
s/^    uint32_t kept = 0, out = 0;/    (void)compare;\n    for (uint32_t i = 1; i < n; i++)\n        for (uint32_t j = i; j > 0 \&\& begins_before(order[j], order[j - 1]); j--) {\n            const uint32_t swap = order[j];\n            order[j] = order[j - 1];\n            order[j - 1] = swap;\n        }\n    uint32_t kept = 0, out = 0;/
