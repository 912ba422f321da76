# code/ch01-near/near.c
# expect: code/ch01-near/near.c:14: this fragment has no title
14s/Keep.*//
