# Measures only the points of the first cell outward that has some.
# expect: though its bound is high enough
# why: The antipode is the furthest place, so whoever lives next to it seems to be the one.
/if (dx \* dx + dy/s/.*/            if (best2 >= 0)/
/if (half \* half + dy/s/.*/        if (best2 >= 0)/
