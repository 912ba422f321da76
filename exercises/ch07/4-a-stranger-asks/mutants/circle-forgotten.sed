# Phase two asks for the row only.
# expect: both meet the square
s|dx \* dx <= square2 && dy \* dy <= square2|(dx < 0 \|\| dy * dy <= square2)|
