# The radius decides the direction, too.
# expect: depend on each other
/random_direction/c\
x = cos(2 * 3.141592653589793 * u), y = sin(2 * 3.141592653589793 * u);
