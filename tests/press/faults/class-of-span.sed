# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: the class "vlaue" is unknown for a span
20s/{.value as=percent/{.vlaue as=percent/
