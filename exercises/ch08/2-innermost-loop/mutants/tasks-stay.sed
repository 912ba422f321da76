# Packs the cells and leaves the tasks where they are.
# expect: pack both, by the same flags
/pack(.*strip->task);/d
