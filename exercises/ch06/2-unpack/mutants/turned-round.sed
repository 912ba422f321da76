# Copies, but hands out the survivors in the wrong order.
# expect: come in reverse
# why: One index runs backward, the other one does not.
s/uint32_t left = 0;/double copy[n + 1]; &/
s/left += keep\[i\]/copy[i] = values[i]/
s/values\[--left\]/copy[left++]/
