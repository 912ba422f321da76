# The counts begin with whatever was there.
# expect: set to 0
s/counts\[b\] = 0;/(void)counts[b];/
