# Strips of a single task.
# expect: need not wait for it
# why: It is the loop that one writes first, and it gives the right places.
s/STRIP = 64/STRIP = 1/
