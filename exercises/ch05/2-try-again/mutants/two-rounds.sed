# The losers are trusted not to collide again.
# expect: Losers collide with each other, too
# why: Losers are few, so they do not expect them to collide again.
s/for (uint32_t left = lanes; left > 0;)/uint32_t left = play(lanes, group); if (left > 0)/
