# Only half the directions.
# expect: Not all directions
s/r \* y/r * fabs(y)/
