# The hole is forgotten.
# expect: inside the hole
/double r =/,/;/c\
double r = sqrt(u) * outer;
