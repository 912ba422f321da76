# code/ch01-near/near.c
# expect: code/ch01-near/near.c:31: this //< closes no fragment
1d
