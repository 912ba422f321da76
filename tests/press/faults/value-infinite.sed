# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "ch01.first.ns / 0" is not a finite number
20s/ch01.first.ns\]/ch01.first.ns \/ 0]/
