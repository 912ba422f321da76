# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:1: the front matter's line "star" is unknown
s/^stars/star/
