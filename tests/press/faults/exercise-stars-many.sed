# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:1: the exercise needs a line "stars: ", from 1 to 5
/^stars/s/2/6/
