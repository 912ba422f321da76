# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "first" is not a number
20s/ch01.first.ns\]/ch01.first.name]/
