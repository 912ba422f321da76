# Every point is a group of its own: no lane collides, at a price.
# expect: Every point is a group of its own
# why: Somebody noticed that a group of one has no collisions.
s/n - i < LANES ? n - i : LANES/1/; s/i += LANES/i++/
