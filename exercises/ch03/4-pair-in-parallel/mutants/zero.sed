# The threads begin with 0, which no distance beats.
# expect: begin with
s/mine = {.distance2 = INFINITY}/mine = {.distance2 = 0}/
