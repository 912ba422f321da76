# Before column 0 comes a very large one.
# expect: In unsigned numbers
s|(uint32_t)((cell + steps + count) % count)|(uint32_t)(cell + steps) < count ? (uint32_t)(cell + steps) : (uint32_t)(cell + steps - (steps > 0 ? count : 0))|
