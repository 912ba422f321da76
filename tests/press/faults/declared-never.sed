# code/ch01-near/near.c
# expect: chapters/ch01-near.md:13: "end" is read here (code/ch01-near/near.c:15), and struct
15s/$/ best += ((struct span *)x)->end;/
