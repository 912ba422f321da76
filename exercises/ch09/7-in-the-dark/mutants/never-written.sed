# Begins with places that nobody has written to.
# expect: holds no key
s/kept\[i\] = nothing();/(void)kept;/
