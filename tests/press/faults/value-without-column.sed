# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "ch01.first" is not the name of a cell
20s/ch01.first.ns\]/ch01.first]/
