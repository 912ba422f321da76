# code/ch01-near/near.c
# expect: code/ch01-near/near.c:1: the fragment "Answer for one point" is never closed
32d
