# The larger ones are compared the wrong way round.
# expect: wrong way round
# why: "Less" is the only question they have, and they forget to turn it round for the larger ones.
s/less(best.largest, large)/less(large, best.largest)/
