# A difference is compared with a squared distance.
# expect: square dx, too
# why: Both are "distances", and in the unit square the mistake only makes the search a little too eager.
s/dx \* dx >= nearest2/fabs(dx) >= nearest2/
