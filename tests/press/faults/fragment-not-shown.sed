# chapters/ch01-near.md
# expect: code/ch01-near/near.c:14: no chapter shows the fragment "Keep the number if it is nearer"
13d
