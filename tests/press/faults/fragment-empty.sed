# code/ch01-near/near.c
# expect: code/ch01-near/near.c:14: the fragment "Keep the number if it is nearer" is empty
15,19d
