# The answers are stored in the order of the rows.
# expect: not to its place in the order
# why: The loop runs over places, and its counter is at hand.
s/nearest\[sorted\[s\].number\] =/nearest[s] =/
