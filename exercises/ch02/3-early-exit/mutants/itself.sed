# The point finds itself.
# expect: A point is not its own neighbor
s/j == i || //
