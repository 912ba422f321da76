# The way may lead all round.
# expect: nothing is new
# why: They let a way go all round, because the remainder forgives it.
s|(count - 1) / 2, count / 2|count - 1, count - 1|
