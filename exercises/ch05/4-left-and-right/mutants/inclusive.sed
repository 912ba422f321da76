# The scan includes the thread's own points.
# expect: its own do not count
s/uint32_t l = left\[t\], /uint32_t l = left[t + 1], /
