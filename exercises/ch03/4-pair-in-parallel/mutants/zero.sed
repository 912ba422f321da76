# The threads begin with 0, which no distance beats.
# expect: begin with
# why: Zero is what memory begins with, and it would be right for a search for the furthest.
s/mine = {.distance2 = INFINITY}/mine = {.distance2 = 0}/
