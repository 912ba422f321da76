# Ends four flags early.
# expect: was it ever written
# why: They unroll by four, and the loop ends where the last vector begins.
s/i < n; i++) {/i + 4 < n; i++) {/
