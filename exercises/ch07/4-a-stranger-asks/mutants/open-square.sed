# The edge of the square is left out.
# expect: just touches the square
s|dx \* dx <= square2 && dy \* dy <= square2|dx * dx < square2 \&\& dy * dy < square2|
