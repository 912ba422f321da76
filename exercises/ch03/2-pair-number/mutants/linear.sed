# Walks from row to row, which takes a time that grows with n.
# expect: a time that grows with n
# why: Walking is right, simple, and fast for every $n$ that one tries by hand.
/uint64_t behind = /i\
    uint32_t i = 0;\
    for (; number >= n - 1 - i; i++)\
        number -= n - 1 - i;\
    return (struct pair){i, (uint32_t)(i + 1 + number)};
/uint64_t behind = /,/behind - triangle/d
