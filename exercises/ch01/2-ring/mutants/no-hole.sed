# The hole is forgotten.
# expect: inside the hole
# why: They find the root for the disc, are pleased, and never come back to the hole.
/double r =/,/;/c\
double r = sqrt(u) * outer;
