# The counts begin with whatever was there.
# expect: set to 0
# why: They took the caller for somebody who clears his arrays, as their own test did.
s/counts\[b\] = 0;/(void)counts[b];/
