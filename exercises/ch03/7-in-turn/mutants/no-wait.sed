# No thread waits.
# expect: in a single atomic step
# why: The number has been drawn, and the loop is left for later.
/while (atomic_load/,/pause_before/d
/atomic_fetch_add/a\
    (void)mine;
