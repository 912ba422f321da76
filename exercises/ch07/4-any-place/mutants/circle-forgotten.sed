# Phase two looks at the row only.
# expect: both meet the square
# why: They cut off rows first, and are satisfied when answers are right and looks fewer.
s|dx \* dx <= square2 && dy \* dy <= square2|(dx < 0 \|\| dy * dy <= square2)|
