# The radius is drawn evenly, not its square.
# expect: the radius itself was drawn evenly
/double r =/,/;/c\
double r = inner + u * (outer - inner);
