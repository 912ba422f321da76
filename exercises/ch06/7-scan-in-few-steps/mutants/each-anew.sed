# Every sum is made from its elements.
# expect: made anew
# why: Every sum is a loop of its own: embarrassingly parallel, and a square of joins.
/^{/,/^}/c\
{\
    for (uint32_t i = 0; i < n; i++) {\
        to[i] = nothing;\
        for (uint32_t j = 0; j < i; j++)\
            to[i] = join(to[i], from[j]);\
    }\
}
