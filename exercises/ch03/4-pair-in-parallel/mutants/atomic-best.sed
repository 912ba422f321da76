# The best and its indices are atomic, and nothing holds them together.
# expect: An update was lost
# why: Each look and each store is one step, so it seems that no guard is needed.
# points: 3
/#pragma omp critical/d
s/^    struct pair best = .*/    _Atomic double least = INFINITY;\
    _Atomic uint64_t code = 0;/
/better(mine, best)/,/best = mine;/c\
        struct pair common = {code >> 32, (uint32_t)code, least};\
        if (better(mine, common)) {\
            least = mine.distance2;\
            code = (uint64_t)mine.i << 32 | mine.j;\
        }
s/^    return best;/    return (struct pair){code >> 32, (uint32_t)code, least};/
