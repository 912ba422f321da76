# The scan includes the thread's own points.
# expect: its own do not count
# why: Both scans are called prefix sums, and one of them was meant.
s/uint32_t l = left\[t\], /uint32_t l = left[t + 1], /
