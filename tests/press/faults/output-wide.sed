# chapters/ch01-near.md
# expect: chapters/ch01-near.md:58: this line is 73 columns wide, and the page has 72
58s|run=".*"|run="printf %73d 1"|
