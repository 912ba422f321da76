# Cuts above the median, whatever comes.
# expect: One part is empty
# why: The other end of the same thought.
s/if (below == 0)/if (below <= n)/
