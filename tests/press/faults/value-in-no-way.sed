# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: as="meters" is neither integer, percent nor seconds
20s/as=integer/as=meters/
