# chapters/ch01-near.md
# expect: chapters/ch01-near.md:34: this answer belongs to no question
33,34d;39d
