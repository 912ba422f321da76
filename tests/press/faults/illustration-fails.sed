# chapters/ch01-near.md
# expect: chapters/ch01-near.md:43: this does not compile
43s/;/,/
