# The way may lead all round.
# expect: nothing is new
s|(count - 1) / 2, count / 2|count - 1, count - 1|
