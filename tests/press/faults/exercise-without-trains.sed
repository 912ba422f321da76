# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:1: the exercise needs a line "trains: "
/^trains/d
