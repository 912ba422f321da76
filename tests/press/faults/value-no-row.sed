# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: no table of ch01 has a row "third"; there are: first, many, second
20s/ch01.first.ns\]/ch01.third.ns]/
