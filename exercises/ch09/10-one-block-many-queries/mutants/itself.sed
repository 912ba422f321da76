# Leaves the query in its own way.
# expect: not its own neighbor
# why: In the plain loop there was a test for it, which the lanes have no place for.
/buffer->x\[q\] = INFINITY;/d
