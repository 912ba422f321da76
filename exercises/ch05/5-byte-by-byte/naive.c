// Reads all records, sorts a copy by itself, and puts them back.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>

static int by_key(const void *a, const void *b)
{
    const struct record *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return p->point < q->point ? -1 : 1;
}

int sort_records(uint32_t n)
{
    struct record *copy = malloc((n + 1) * sizeof *copy);
    for (uint32_t i = 0; i < n; i++)
        copy[i] = get(0, i);
    qsort(copy, n, sizeof *copy, by_key);
    for (uint32_t i = 0; i < n; i++)
        put(0, i, copy[i]);
    free(copy);
    return 0;
}
