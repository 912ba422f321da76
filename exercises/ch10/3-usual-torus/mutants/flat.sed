# Bounds cells as if the box did not wrap around.
# expect: there is a way around
# why: The distances are measured by a given function, so it is easy to forget that the bounds wrap around, too.
s/return d < n - d ? d : n - d/return d/
s/if (half \* half/if (4 * half * half/
