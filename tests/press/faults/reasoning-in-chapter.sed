# chapters/ch01-near.md
# expect: chapters/ch01-near.md:33: reasoning belongs into an exercise
33s/quick/reasoning/
