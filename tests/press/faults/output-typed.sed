# chapters/ch01-near.md
# expect: chapters/ch01-near.md:61: output is captured, not typed
61s/$/\
typed/
