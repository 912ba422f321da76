# Packs places and leaves the tasks.
# expect: do a lane's task, place and end stay together
/lanes->task\[kept\] =/d
