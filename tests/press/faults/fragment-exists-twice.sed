# code/ch01-near/near.c
# expect: code/ch01-near/near.c:14: the fragment "Answer for one point" exists twice, here and at code/ch01-near/near.c:1
14s/Keep.*/Answer for one point/
