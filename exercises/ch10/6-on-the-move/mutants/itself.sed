# Finds the point itself.
# expect: not its own neighbor
# why: It is in the list, too.
s/if (j == i)/if (0)/
