# chapters/ch01-near.md
# expect: chapters/ch01-near.md:24: this table needs a caption
30d
