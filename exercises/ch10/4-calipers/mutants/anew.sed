# Searches anew for every side.
# expect: go on from where you are
# why: It is the search for one side, in a loop.
s/^        while/        k = (i + 1) % n;\n&/
