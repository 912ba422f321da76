# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: digits="few" is not a whole number
20s/digits=2/digits=few/
