# A better point replaces the worst, and no order is kept.
# expect: not in order
# why: Replacing the worst is enough to keep the right set, and the order is left for later.
s/while (place > 0 && /while (0 \&\& /
