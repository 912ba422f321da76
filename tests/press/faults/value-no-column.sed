# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: no table of ch01 has a column "ms" in row "first"; there are: name, ns, points, share
20s/ch01.first.ns\]/ch01.first.ms]/
