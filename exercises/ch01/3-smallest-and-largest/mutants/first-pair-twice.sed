# The first pair is compared with itself: two comparisons too many.
# expect: the first pair
s/if (i == 0) {/if (n == 0) {/
