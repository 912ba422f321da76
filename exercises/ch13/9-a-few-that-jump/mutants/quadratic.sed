# Sorts what was taken out by swapping neighbors.
# expect: not so little that any sort will do
# why: Four hundred numbers are few.
s/^    qsort(room, out, sizeof \*room, compare);/    (void)compare;\n    for (uint32_t i = 1; i < out; i++)\n        for (uint32_t j = i; j > 0 \&\& begins_before(room[j], room[j - 1]); j--) {\n            const uint32_t swap = room[j];\n            room[j] = room[j - 1];\n            room[j - 1] = swap;\n        }/
