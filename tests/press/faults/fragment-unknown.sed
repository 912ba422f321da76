# chapters/ch01-near.md
# expect: chapters/ch01-near.md:6: no fragment is called "Answer for no point"
6s/one/no/
