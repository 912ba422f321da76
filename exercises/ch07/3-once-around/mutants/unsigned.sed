# Before column 0 comes a very large one.
# expect: In unsigned numbers
# why: The columns are unsigned in the struct, so the steps become so as well.
s|(uint32_t)((cell + steps + count) % count)|(uint32_t)(cell + steps) < count ? (uint32_t)(cell + steps) : (uint32_t)(cell + steps - (steps > 0 ? count : 0))|
