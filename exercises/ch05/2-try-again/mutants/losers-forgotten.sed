# There is no second round.
# expect: Every group counted this cell just once
s/left = play(left, group)/play(left, group), left = 0/
