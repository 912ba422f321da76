# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: this span has no class
20s/{.given}/{by=me}/
