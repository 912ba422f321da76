# The distance itself instead of its square.
# expect: its root
s/return best;/best.distance2 = sqrt(best.distance2); return best;/
