# Begins with places that were never written to.
# expect: holds no key
# why: The places are filled in the first k steps, they think, and with fewer keys they are not.
s/kept\[i\] = nothing();/(void)kept;/
