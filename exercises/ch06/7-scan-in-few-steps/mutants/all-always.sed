# In every step all lanes join, and the distance doubles.
# expect: Few steps, but
# why: It is the scan of Hillis and Steele, found in every course on graphics processors.
/^{/,/^}/c\
{\
    for (uint32_t i = 0; i < n; i++)\
        to[i] = i == 0 ? nothing : from[i - 1];\
    for (uint32_t d = 1; d < n; d *= 2)\
        for (uint32_t i = n; i-- > d;)\
            to[i] = join(to[i - d], to[i]);\
}
