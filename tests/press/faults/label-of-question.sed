# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: a division of class "quick" has no label
33s/quick/{.quick #why}/
