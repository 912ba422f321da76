# Calls next_cell for all lanes before every round.
# expect: has measured all points of its cell goes on
# why: It is simplest to call it for all lanes before each round, since the answer for the others could be ignored.
/if (lanes->place\[l\] == lanes->end\[l\])/d
