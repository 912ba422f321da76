# Blocks, but their sums one by one.
# expect: as small as can be
# why: It is the chapter's scan, and the best one for few threads.
/^{/,/^}/c\
{\
    uint32_t b = 1;\
    while (b * b < n)\
        b++;\
    struct sum before = nothing;\
    for (uint32_t k = 0; k < n; k += b) {\
        struct sum all = nothing;\
        for (uint32_t i = k; i < n && i < k + b; i++) {\
            to[i] = join(before, all);\
            all = join(all, from[i]);\
        }\
        before = join(before, all);\
    }\
}
