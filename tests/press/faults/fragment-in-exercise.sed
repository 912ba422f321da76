# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:18: an exercise shows no fragments
/^Look/s/.*/~~~ fragment\
Answer for one point\
~~~/
