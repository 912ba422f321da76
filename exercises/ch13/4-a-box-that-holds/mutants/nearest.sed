# Converts to the nearest number.
# expect: round outward
# why: A conversion does not look like a computation that rounds.
s/return nearest <= safe ? nearest : nextafterf(nearest, -INFINITY);/return nearest;/
s/nextafter(x - reach, -INFINITY)/x - reach/
