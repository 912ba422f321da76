# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: "os" is not known here
20s/ch01.first.ns\]/os.time()]/
