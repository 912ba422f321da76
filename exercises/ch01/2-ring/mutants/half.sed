# Only half the directions.
# expect: Not all directions
# why: An angle from 0 to 180 degrees, or a root that knows no sign, covers one half of the circle and looks like a circle in a quick plot with equal axes forgotten.
s/r \* y/r * fabs(y)/
