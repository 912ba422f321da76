# Half way round is reached from both sides.
# expect: just half way round, and has been reached
# why: Symmetry: as many steps back as ahead.
s|(count - 1) / 2, count / 2|count / 2, count / 2|
