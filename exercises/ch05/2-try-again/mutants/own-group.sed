# Every point is a group of its own: nobody collides, at a price.
# expect: Every point is a group of its own
s/n - i < LANES ? n - i : LANES/1/
