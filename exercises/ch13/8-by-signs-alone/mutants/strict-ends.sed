# Takes an end in the plane for a miss.
# expect: An end of the segment is in the triangle
# why: The product of the two signs is to be negative.
s/if (begin \* end > 0)/if (begin * end > 0 || (begin == 0) != (end == 0))/
