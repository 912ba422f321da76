# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: the attribute "digit" is unknown for a span of class "value"
20s/digits=/digit=/
