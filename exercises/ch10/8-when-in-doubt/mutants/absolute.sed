# Takes a margin that does not depend on the box.
# expect: small part of the box's own size
# why: 1e-9 is what one writes where doubles are compared.
s/0x1p-20 \* hypot.*/1e-9 + 0 * (high - low);/
