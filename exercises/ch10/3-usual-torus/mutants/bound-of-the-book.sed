# Bounds cells by the larger of d and P - d.
# expect: Is the bound that of the larger
# why: The chapter's furthest image takes the larger one, and its code is at hand.
s/return d < n - d ? d : n - d/return d > n - d ? d : n - d/
s/return n \/ 2.0;/return n;/
s/if (half \* half/if (4 * half * half/
