# Only the left half asks.
# expect: both halves must walk
# why: The distance of a pair is the same from either side, but not their circles.
s/j < rights; j++) {$/&/;s/keep_less(q, measure(i, j))/keep_less(q, q->nearest2)/
