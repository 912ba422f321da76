# The first point that is too far in x ends the whole search.
# expect: ends the search
s/if (j == i || dx \* dx >= nearest2)/if (dx * dx >= nearest2 \&\& j != i) break; else if (j == i)/
