# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: a hint belongs into an exercise
33s/quick/hint/
