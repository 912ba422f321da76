# Merges without sorting what was taken out.
# expect: Were both lists in order
# why: It was in order in the step before.
s/^    qsort(room, out, sizeof \*room, compare);/    (void)compare;/
