# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: the index has no entry "bin" to see
20s/see="cell"/see="bin"/
