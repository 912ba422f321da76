# Stores as if to began at a multiple of 16 bytes.
# expect: an aligned load or store
# why: The name without the u is the shorter one, and most arrays are aligned. (Like an aligned store, this one ends the program.)
s/^    for (uint32_t i = 0; i < n; i++) {$/    if ((uintptr_t)to % 16 > 0)\
        *(volatile uint32_t *)0 = hole;\
&/
