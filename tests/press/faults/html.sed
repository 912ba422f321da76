# chapters/ch01-near.md
# expect: chapters/ch01-near.md:70: raw html cannot be printed
70s|.*|<hr>|
