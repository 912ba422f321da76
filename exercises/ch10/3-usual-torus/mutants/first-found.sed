# Stops after the first row in which there is a point.
# expect: though its bound is high enough
# why: Among uniform points, it is nearly always right.
/if (half \* half + dy/s/.*/        if (best2 >= 0)/
