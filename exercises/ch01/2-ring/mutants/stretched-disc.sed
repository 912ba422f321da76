# Right for a disc, and then squeezed into the ring.
# expect: squeezed
# why: They take the right formula for a disc and scale it into the ring, as one may with numbers on a line, but not with areas.
/double r =/,/;/c\
double r = inner + sqrt(u) * (outer - inner);
