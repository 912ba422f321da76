# The blocks are n / LANES, rounded down.
# expect: rounded down
s/(n + LANES - 1) \/ LANES/n \/ LANES/
