# Packs the cells and leaves the tasks where they are.
# expect: pack both, by the same flags
# why: Two vectors, one pack.
/pack(.*strip->task);/d
