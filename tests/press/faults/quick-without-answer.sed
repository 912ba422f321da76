# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: this quick question has no answer
36,38d
