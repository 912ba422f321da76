# Keeps the sides from a point to itself.
# expect: from a point to itself
# why: Where the set is a square, no two of the eight seem to be the same; on its corner, three are.
s/if (a != 0 || b != 0)/if (true)/
