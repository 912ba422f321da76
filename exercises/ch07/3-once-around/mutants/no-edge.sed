# The edge is not respected.
# expect: sticks out of the grid
# why: The test for the edge is made in one direction only.
s|return (struct search_range){cell, count - 1 - cell};|return (struct search_range){count, count};|
s|(uint32_t)((cell + steps + count) % count)|(uint32_t)(cell + steps)|
