# There is no second round.
# expect: Every group counted this cell just once
# why: The winners are counted, and the example had hardly any losers.
s/left = play(left, group)/play(left, group), left = 0/
