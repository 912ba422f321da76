# chapters/ch01-near.md
# expect: chapters/ch01-near.md:16: "1.5" looks like a measurement typed by hand
16s/a value/1.5/
