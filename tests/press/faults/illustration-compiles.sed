# chapters/ch01-near.md
# expect: chapters/ch01-near.md:55: this is said to fail, but it compiles
55s/no_such_thing/0/
