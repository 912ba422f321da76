# Packs when less than half is alive, at any price.
# expect: less than half is alive
s/idle >= (uint64_t)price \* lanes/alive < lanes \/ 2.0/
