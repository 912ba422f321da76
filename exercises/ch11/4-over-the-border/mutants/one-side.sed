# Only the left half asks.
# expect: both halves must ask
# why: The distance of a pair is the same from either side, but not their circles.
s/j < rights; j++) {$/&/;s/meet(q, measure(i, j))/meet(q, q->nearest2)/
