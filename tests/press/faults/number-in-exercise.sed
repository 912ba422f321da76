# exercises/ch01/1-tie/exercise.md
# expect: exercises/ch01/1-tie/exercise.md:14: "2.5 GHz" looks like a measurement typed by hand
/^Change/s/$/ It runs at 2.5 GHz./
