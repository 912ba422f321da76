# exercises/ch01/1-tie/mutants/first.sed
# expect: exercises/ch01/1-tie/mutants/first.sed:1: a mutant's first lines say which mistake
# solutions
3d
