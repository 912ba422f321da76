# chapters/ch01-near.md
# expect: chapters/ch01-near.md:3: no fragment is called "Answer for no point"
3s/Answer for one/Answer for no/
