# chapters/ch01-near.md
# expect: chapters/ch01-near.md:49: this does not compile
48s/, double y//
