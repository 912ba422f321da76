# chapters/ch01-near.md
# expect: chapters/ch01-near.md:55: the class "fail" is unknown for C
54s/fails/fail/
