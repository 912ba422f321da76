# Packs places and leaves the tasks.
# expect: do a lane's task, place and end stay together
# why: Four vectors are packed, and they forget one.
/lanes->task\[kept\] =/d
