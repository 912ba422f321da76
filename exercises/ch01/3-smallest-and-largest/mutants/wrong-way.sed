# The larger ones are compared the wrong way round.
# expect: wrong way round
s/less(best.largest, large)/less(large, best.largest)/
