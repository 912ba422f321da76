# The radius decides the direction, too.
# expect: depend on each other
# why: They save a call, and believe that one random number is as good as two.
/random_direction/c\
x = cos(2 * 3.141592653589793 * u), y = sin(2 * 3.141592653589793 * u);
