# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: this figure needs a caption
22s/^!\[.*\](/![](/
