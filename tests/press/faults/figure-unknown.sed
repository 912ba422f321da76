# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: there is no figure ch01-speeds in
22s/(ch01-speed)/(ch01-speeds)/
