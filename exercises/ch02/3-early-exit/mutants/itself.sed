# The point finds itself.
# expect: A point is not its own neighbor
# why: The starter did so, and the distance 0 is hard to beat.
s/j == i || //
