# The radius is drawn evenly, not its square.
# expect: the radius itself was drawn evenly
# why: "Evenly" is heard as "evenly in every coordinate that I use", and the radius is one of them.
/double r =/,/;/c\
double r = inner + u * (outer - inner);
