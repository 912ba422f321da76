# chapters/ch01-near.md
# expect: chapters/ch01-near.md:78: "23 ms" looks like a measurement typed by hand
78s/$/ It took 23 ms, all in all./
