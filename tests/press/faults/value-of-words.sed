# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "2 * ch01.first.name" cannot be computed
20s/ch01.first.ns\]/2 * ch01.first.name]/
