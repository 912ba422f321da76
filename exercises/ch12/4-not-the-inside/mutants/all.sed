# Looks at all points.
# expect: difference of two starts
# why: It is right.
s/            last - first < 2) {/            last - first < 1u << 31) {/
