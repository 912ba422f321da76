# Forgets what was put aside.
# expect: in their order
# why: The count is right, and so is the front.
s/    memcpy(list + first, room.*/    (void)room;/
