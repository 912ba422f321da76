# chapters/ch01-near.md
# expect: chapters/ch01-near.md:76: a chapter has one title, its first line
76s/##/#/
