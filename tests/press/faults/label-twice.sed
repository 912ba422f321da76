# chapters/ch01-near.md
# expect: chapters/ch01-near.md:76: the label "sec:cost" exists twice, here and at chapters/ch01-near.md:18
76s/$/ {#sec:cost}/
