# Keeps those who have finished.
# expect: for those who have not finished
s/strip->keep\[l\] = step </strip->keep[l] = step >=/
