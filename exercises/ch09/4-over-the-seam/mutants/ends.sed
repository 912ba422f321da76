# Ends at the edges.
# expect: the last column is beside the first
# why: It is the block of the chapter's standard geometry.
/if (at < reach) {/,/^    }/{s/return 2/return 1/;s/to\[1\].*//}
/if (at + reach >= count) {/,/^    }/{s/0, at + reach - count/at - reach, count - 1/;s/to\[1\].*//;s/return 2/return 1/}
