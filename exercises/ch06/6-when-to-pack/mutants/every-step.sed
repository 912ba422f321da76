# Packs after every step.
# expect: after every step
# why: It is what Su did, and what the chapter shows first.
s/idle >= (uint64_t)price \* lanes/price > 0/
