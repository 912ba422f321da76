# Compares a squared distance with a distance.
# expect: is either of them squared
# why: Below 1 the square is the smaller one, and nobody notices at first.
s/best.d2 < certain \* certain/best.d2 < certain/
