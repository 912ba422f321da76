# code/ch01-near/near.c
# expect: code/ch01-near/near.c:33: this line is in no fragment
32s/$/\
int outside;/
