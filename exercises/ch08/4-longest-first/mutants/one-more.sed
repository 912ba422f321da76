# Lets a task work one step too long.
# expect: only tasks longer than b
s/step(places\[b\], order)/step(places[b - 1], order)/
