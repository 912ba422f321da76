# What lies above the present height is taken as fresh.
# expect: How high has the stack been
# why: One keeps where the stack is, and not where it was.
s/if (top > highest)/if (top != highest)/
