# chapters/ch01-near.md
# expect: chapters/ch01-near.md:58: this line is 80 columns wide, and the page has 72: $ printf
58s/run="printf/run="printf       /;58s/three/three, and then some more, and even more than that/
