# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "ch01.many.points" is neither true nor false
20s/10 < ch01.many/ch01.many/
