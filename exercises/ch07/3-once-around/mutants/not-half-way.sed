# Half way round is never reached.
# expect: it has to be taken from one side
# why: The other symmetric choice: (m - 1) / 2 in both directions.
s|(count - 1) / 2, count / 2|(count - 1) / 2, (count - 1) / 2|
