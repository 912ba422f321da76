# Treats the plane like all the rest.
# expect: All lies in one plane
# why: All signs are 0, and not both signs are among them.
s/if (begin == 0 && end == 0)/if (0)/
