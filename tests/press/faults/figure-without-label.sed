# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: this figure needs a label: {#fig:ch01-speed}
22s/{#fig.*//
