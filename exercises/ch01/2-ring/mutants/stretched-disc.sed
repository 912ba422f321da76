# Right for a disc, and then squeezed into the ring.
# expect: squeezed
/double r =/,/;/c\
double r = inner + sqrt(u) * (outer - inner);
