# Memory is taken as cleared, kept or not.
# expect: Only memory that nobody has ever taken
# why: The text says that fresh memory is 0, and this was fresh once.
s/return memset(memory.*/return (void)used, memory + begin;/
