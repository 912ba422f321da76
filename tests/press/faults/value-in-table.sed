# chapters/ch01-near.md
# expect: chapters/ch01-near.md:28: no table of ch01 has a row "third"
28s/ch01.second/ch01.third/
