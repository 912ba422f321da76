# The plain loop.
# expect: Every join waits for the one before it
# why: The plain loop is in the starter, and right.
/^{/,/^}/c\
{\
    for (uint32_t i = 0; i < n; i++)\
        to[i] = i == 0 ? nothing : join(to[i - 1], from[i - 1]);\
}
