# The first pair is compared with itself: two comparisons too many.
# expect: the first pair
# why: The first pair is treated like the others. The answer is right, so only the count tells.
s/if (i == 0) {/if (n == 0) {/
