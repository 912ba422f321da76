# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: there is no table "ch01-speed"
22s/ch01-speeds/ch01-speed/
