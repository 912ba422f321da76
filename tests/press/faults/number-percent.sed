# chapters/ch01-near.md
# expect: chapters/ch01-near.md:78: "23%" looks like a measurement typed by hand
78s/$/ It was 23% of all./
