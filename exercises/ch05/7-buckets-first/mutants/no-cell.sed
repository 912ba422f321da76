# Eleven bits in each round.
# expect: memory that is not its own
# why: They counted the bits of four million cells, and the promise was $2^{24}$.
s/BITS = 12/BITS = 11/
