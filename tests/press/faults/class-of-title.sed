# chapters/ch01-near.md
# expect: chapters/ch01-near.md:76: the class "small" is unknown for a title
76s/$/ {.small}/
