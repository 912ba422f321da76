# Sorts a bucket from its end.
# expect: points of a cell keep their order
# why: A count that is scanned to the ends of cells is filled from behind, and then the loop must run backward, too.
s/    for (uint32_t s = begin; s < end; s++) {/    for (uint32_t s = end; s-- > begin;) {/
