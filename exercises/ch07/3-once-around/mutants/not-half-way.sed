# Half way round is never reached.
# expect: it has to be taken from one side
s|(count - 1) / 2, count / 2|(count - 1) / 2, (count - 1) / 2|
