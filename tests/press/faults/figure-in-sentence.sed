# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: a figure must be a paragraph of its own
22s/$/ See?/
