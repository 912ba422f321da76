# Looks from the beginning of the order.
# expect: Look only at boxes that follow
# why: The inner loop is written as the outer one.
s/uint32_t s = r + 1;/uint32_t s = 0;/
s/if (meet_across/if (s != r \&\& begins_within(order[s], order[r]) \&\& meet_across/
