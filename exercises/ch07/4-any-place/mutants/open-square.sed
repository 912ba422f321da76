# The edge of the square is left out.
# expect: just touches the square
# why: Less, or less or equal: the point on the edge is as near as the best and may have the lower index.
s|dx \* dx <= square2 && dy \* dy <= square2|dx * dx < square2 \&\& dy * dy < square2|
