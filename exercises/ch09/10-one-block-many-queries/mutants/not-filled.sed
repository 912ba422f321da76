# Leaves in the last lanes what was there before.
# expect: from the block before
# why: The count is rounded up, and the places behind it are forgotten.
s/buffer->x\[n\] = buffer->y\[n\] = INFINITY;/continue;/
