# A better point replaces the worst, and no order is kept.
# expect: not in order
s/while (place > 0 && /while (0 \&\& /
