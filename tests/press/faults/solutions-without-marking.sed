# exercises/ch01/2-paper/exercise.md
# expect: exercises/ch01/2-paper/exercise.md:1: the manual needs its "::: marking"
# solutions
/^::: marking/,/^:::$/d
