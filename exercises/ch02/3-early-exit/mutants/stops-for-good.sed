# The first point that is too far in x ends the whole search.
# expect: ends the search
# why: In a list sorted by $x$ it would be right, and they have seen that one.
s/if (j == i || dx \* dx >= nearest2)/if (dx * dx >= nearest2 \&\& j != i) break; else if (j == i)/
