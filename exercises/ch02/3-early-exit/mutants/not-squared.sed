# A difference is compared with a squared distance.
# expect: square dx, too
s/dx \* dx >= nearest2/fabs(dx) >= nearest2/
