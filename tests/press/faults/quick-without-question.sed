# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: this quick question asks nothing
34d
