# The arc begins where the gap begins.
# expect: begins where the gap ends
# why: Of a gap from one point to the next, each of the two is "the beginning" of something.
s/start = sorted\[i\];/start = sorted[i - 1];/
