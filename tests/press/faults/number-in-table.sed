# chapters/ch01-near.md
# expect: chapters/ch01-near.md:28: "2.5" looks like a measurement typed by hand
28s/without/2.5 without/
