# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: an index entry needs words or a key
20s/ key="cell!empty"//
