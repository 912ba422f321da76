# code/ch01-near/near.c
# expect: code/ch01-near/near.c:1: this line is in no fragment
1,1s/.*/int outside;/
