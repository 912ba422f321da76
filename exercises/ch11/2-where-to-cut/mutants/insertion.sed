# Sorts by insertion.
# expect: Does it become n squared
# why: It is five lines, and a hundred numbers do not show it.
# points: 8
s/^    qsort(value, n, sizeof \*value, ascending);/    (void)ascending;\n    for (uint32_t k = 1; k < n; k++) {\n        const double x = value[k];\n        uint32_t j = k;\n        for (; j > 0 \&\& value[j - 1] > x; j--)\n            value[j] = value[j - 1];\n        value[j] = x;\n    }/
