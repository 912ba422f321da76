# The arc begins where the gap begins.
# expect: begins where the gap ends
s/start = sorted\[i\];/start = sorted[i - 1];/
