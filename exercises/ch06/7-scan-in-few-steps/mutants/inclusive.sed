# Adds the element itself, too.
# expect: This is the inclusive scan
# why: Inclusive sums are what a loop makes without thinking.
/^{/,/^}/c\
{\
    struct sum sum = nothing;\
    for (uint32_t i = 0; i < n; i++) {\
        to[i] = i == 0 ? nothing : join(sum, from[i]);\
        sum = join(sum, from[i]);\
    }\
}
