# Lets a task work one step too long.
# expect: only tasks longer than b
# why: places[b] after the placing is not what it was before it.
s/step(places\[b\], order)/step(places[b - 1], order)/
