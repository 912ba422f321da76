# The blocks are n / LANES, rounded down.
# expect: rounded down
# why: n / LANES is what comes to mind, and the last points have no lane.
s/(n + LANES - 1) \/ LANES/n \/ LANES/
