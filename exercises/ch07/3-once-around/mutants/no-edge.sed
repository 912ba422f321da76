# The edge is not respected.
# expect: sticks out of the grid
s|return (struct view){cell, count - 1 - cell};|return (struct view){count, count};|
s|(uint32_t)((cell + steps + count) % count)|(uint32_t)(cell + steps)|
