// Sorts the indices by cell, by comparisons, and copies.
// expect: 4 of 10
#include "exercise.h"
#include <stdlib.h>

struct entry {
    uint32_t cell, point;
};

static int by_cell(const void *a, const void *b)
{
    const struct entry *p = a, *q = b;
    if (p->cell != q->cell)
        return p->cell < q->cell ? -1 : 1;
    return p->point < q->point ? -1 : 1;
}

void sort_into_cells(struct points points, struct grid grid,
                     struct sorted *sorted)
{
    struct entry *entries = malloc((points.n + 1) * sizeof *entries);
    for (uint32_t i = 0; i < points.n; i++)
        entries[i] =
            (struct entry){cell_at(grid, points.x[i], points.y[i]), i};
    qsort(entries, points.n, sizeof *entries, by_cell);
    uint32_t k = 0;
    for (uint32_t s = 0; s < points.n; s++) {
        while (k <= entries[s].cell)
            sorted->start[k++] = s;
        sorted->index[s] = entries[s].point;
        sorted->x[s] = points.x[entries[s].point];
        sorted->y[s] = points.y[entries[s].point];
    }
    while (k <= grid.columns * grid.rows)
        sorted->start[k++] = points.n;
    free(entries);
}
