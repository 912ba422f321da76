# Packs when less than half is alive, at any price.
# expect: less than half is alive
# why: The text says that it will do, for lifetimes that are nothing special.
s/idle >= (uint64_t)price \* lanes/alive < lanes \/ 2.0/
