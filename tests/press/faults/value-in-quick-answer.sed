# chapters/ch01-near.md
# expect: chapters/ch01-near.md:37: no table of ch01 has a row "third"
37s/second/third/
