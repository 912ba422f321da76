# chapters/ch01-near.md
# expect: chapters/ch01-near.md:78: "1.5" looks like a measurement typed by hand
78s/$/ It took 1.5 of them./
