# Goes to both sides always.
# expect: Leave out what cannot
# why: The bound was left for later.
s/^        search->best2)$/        INFINITY)/
