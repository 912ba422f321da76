# Lets a task work one round too long.
# expect: only tasks longer than b
# why: places[b] after the placing is not what it was before it.
s/make_round(places\[b\], order)/make_round(places[b - 1], order)/
