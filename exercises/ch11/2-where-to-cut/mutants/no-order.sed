# Leaves the numbers in their order, and counts in a copy.
# expect: order the array
# why: How many there are is only half of the answer.
s/    qsort(value, n, sizeof \*value, ascending);/    double copy[2000];\n    for (uint32_t k = 0; k < n; k++)\n        copy[k] = value[k];\n    value = copy;\n&/
