# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: ch02 has no table whose rows have names
20s/ch01.first.ns\]/ch02.first.ns]/
