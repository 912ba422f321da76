# Half way round is reached from both sides.
# expect: just half way round, and has been reached
s|(count - 1) / 2, count / 2|count / 2, count / 2|
