# Puts the shortest first.
# expect: which end of the order
# why: Sorting is ascending, by habit.
s/for (uint32_t b = longest + 1; b-- > 0;) {/for (uint32_t b = 0; b <= longest; b++) {/
