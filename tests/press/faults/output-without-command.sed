# chapters/ch01-near.md
# expect: chapters/ch01-near.md:58: output needs its command
58s/run="[^"]*"//
