# Does not look for duplicates.
# expect: follows its own duplicate
# why: Most random inputs have none, and a duplicate seems to vanish by itself, as any point that does not turn.
s/points.x\[i\] != points.x\[j\] .*/i != j)/
