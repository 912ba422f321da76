# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:24: the exercise has two divisions "marking"
s/^::: reasoning/::: marking/
