# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:1: the manual needs its "::: reasoning"
# solutions
/^::: reasoning/,/^:::$/d
