# chapters/ch01-near.md
# expect: chapters/ch01-near.md:18: the label "cost" should begin with "sec:"
18s/sec:cost/cost/
