# Packs the place and the steps, but not the task.
# expect: stay together
# why: The task's number does not change, so it seems that it need not move.
/task\[kept\] = task\[l\];/d
