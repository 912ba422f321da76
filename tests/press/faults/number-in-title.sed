# chapters/ch01-near.md
# expect: chapters/ch01-near.md:18: "10 times as" looks like a measurement typed by hand
18s/What it costs/10 times as much/
