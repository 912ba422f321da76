# chapters/ch01-near.md
# expect: chapters/ch01-near.md:1: a chapter begins with its title
1s/# //
