# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: a reported number needs its source
20s/ by=coursework//
