# Keeps the tasks that have finished.
# expect: for tasks that have not finished
# why: "Finished" and "unfinished" are one exclamation mark apart.
s/strip->keep\[l\] = step </strip->keep[l] = step >=/
