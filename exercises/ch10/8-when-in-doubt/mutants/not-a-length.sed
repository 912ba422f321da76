# Compares a turn with a length.
# expect: size
# why: The turn is the height above the line, but for a factor that is easily forgotten.
s/margin \* hypot(c->x - a->x, c->y - a->y)/margin/
