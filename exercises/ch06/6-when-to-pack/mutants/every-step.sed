# Packs after every step.
# expect: after every step
s/idle >= (uint64_t)price \* lanes/price > 0/
