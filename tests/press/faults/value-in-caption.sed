# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: no table of ch01 has a row "none"
22s/ch01.many/ch01.none/
