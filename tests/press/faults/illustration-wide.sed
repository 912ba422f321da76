# chapters/ch01-near.md
# expect: chapters/ch01-near.md:49: this line is 88 columns wide, and the page has 72
49s|$| and here somebody goes on at length, for no reason|
