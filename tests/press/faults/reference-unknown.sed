# chapters/ch01-near.md
# expect: chapters/ch01-near.md:20: there is nothing with the label "sec:price"
20s/@sec:cost/@sec:price/
