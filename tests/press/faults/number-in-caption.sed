# chapters/ch01-near.md
# expect: chapters/ch01-near.md:22: "2.5" looks like a measurement typed by hand
22s/lower/2.5 lower/
