# The losers are counted one by one, as in figure 4.
# expect: let them form a group
# why: It is figure 4, which they have just read.
s/for (uint32_t left = lanes; left > 0;)/for (uint32_t left = play(lanes, group); left > 0; left--)/
s/left = play(left, group)/play(1, \&group[left - 1])/
