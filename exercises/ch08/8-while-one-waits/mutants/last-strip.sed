# Leaves out the last strip if it is not full.
# expect: where the last strip is not full
# why: The loop is copied from one in which the number of tasks was a multiple.
s/t < tasks; t += STRIP/t + STRIP <= tasks; t += STRIP/
