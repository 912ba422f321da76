# Joins the truths with branches.
# expect: compute truths instead
# why: One is used to the doubled sign.
s/ & (high/ \&\& (high/
s/ &$/ \&\&/
s/found\[count\] = i;/if (meets[i - first]) found[count++] = i;/
s/^            count += meets\[i - first\];//
s/^        compare(boxes, box, first, end, meets);/        for (uint32_t i = first; i < end; i++) { compare(boxes, box, i, i + 1, meets + i - first); __asm__ volatile("" ::: "memory"); }/
