// How many points a point shares its cell with, itself included, in one
// grid, in one of a hundred times as many cells, in a grid whose
// crowded cells have grids, and in strips by x cut into boxes by y. And
// how often a monotonic logical grid (Boris and Lambrakos 1985) is
// wrong about the nearest. Counts only.
//
//     repairs [POINTS]
#include "algorithms.h"
#include "ch04-cell-sort/line.h"
#include "ch04-cell-sort/sorted.h"
#include "common/allocate.h"
#include "common/experiment.h"
#include "common/generate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

// The points of all cells, squared; of a cell with more than a few, if
// there are more levels, those of a grid inside.
static double squares(struct points points, double c, int levels)
{
    enum { FEW = 8 };
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct sorted sorted = sorted_make(&question, c);
    const uint32_t *start = sorted.cells.start;
    double sum = 0;
    for (uint32_t k = 0; k < grid_cells(&sorted.grid); k++) {
        const uint32_t n = start[k + 1] - start[k];
        const struct points cell = {n, sorted.points.x + start[k],
                                    sorted.points.y + start[k]};
        sum += n > FEW && levels > 1 ? squares(cell, c, levels - 1)
                                     : (double)n * n;
    }
    sorted_free(&sorted);
    return sum;
}

// Strips of equally many points by x, and each cut by the same cuts in
// y, of equally many of all points: a grid that is fitted to them.
static double *cuts_of(const double *value, uint32_t n, uint32_t count)
{
    double *copy = allocate(n, sizeof *copy);
    double *cut = allocate(count, sizeof *cut);
    memcpy(copy, value, n * sizeof *copy);
    sort_numbers(copy, n);
    for (uint32_t k = 0; k < count; k++)
        cut[k] = copy[(uint64_t)n * k / count];
    free(copy);
    return cut;
}

static uint32_t place_of(const double *cut, uint32_t count, double x)
{
    uint32_t first = 0, end = count;
    while (end - first > 1) {
        const uint32_t middle = (first + end) / 2;
        *(cut[middle] <= x ? &first : &end) = middle;
    }
    return first;
}

static double fitted(struct points p, double c)
{
    const uint32_t side = (uint32_t)ceil(sqrt(p.n / c));
    double *x = cuts_of(p.x, p.n, side), *y = cuts_of(p.y, p.n, side);
    uint32_t *count = allocate((size_t)side * side, sizeof *count);
    double sum = 0;
    memset(count, 0, (size_t)side * side * sizeof *count);
    for (uint32_t i = 0; i < p.n; i++)
        count[place_of(y, side, p.y[i]) * side +
              place_of(x, side, p.x[i])]++;
    for (uint32_t k = 0; k < side * side; k++)
        sum += (double)count[k] * count[k];
    free(count);
    free(y);
    free(x);
    return sum;
}

// Sorted by x into columns, each sorted by y: the nearest is looked for
// in the nine places around.
struct numbered {
    double x, y;
    uint32_t point;
};

static int by_x(const void *one, const void *other)
{
    const struct numbered *a = one, *b = other;
    return (a->x > b->x) - (a->x < b->x);
}

static int by_y(const void *one, const void *other)
{
    const struct numbered *a = one, *b = other;
    return (a->y > b->y) - (a->y < b->y);
}

static double nearest_around(const struct numbered *p, uint32_t n,
                             uint32_t side, uint32_t k)
{
    double best2 = INFINITY;
    for (int column = -1; column <= 1; column++)
        for (int row = -1; row <= 1; row++) {
            int64_t at = (int64_t)k + column * (int64_t)side + row;
            if (at >= 0 && at < n && at != k)
                best2 = fmin(best2, distance2(p[at].x - p[k].x,
                                              p[at].y - p[k].y));
        }
    return best2;
}

static double share_wrong(struct points points)
{
    const uint32_t n = points.n, side = (uint32_t)ceil(sqrt(n));
    struct numbered *p = allocate(n, sizeof *p);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct answers right = answers_for(n, NEAREST);
    uint32_t wrong = 0;
    find_algorithm("adaptive")->run(&question, &right);
    for (uint32_t i = 0; i < n; i++)
        p[i] = (struct numbered){points.x[i], points.y[i], i};
    qsort(p, n, sizeof *p, by_x);
    for (uint32_t k = 0; k < n; k += side)
        qsort(p + k, n - k < side ? n - k : side, sizeof *p, by_y);
    for (uint32_t k = 0; k < n; k++)
        wrong +=
            nearest_around(p, n, side, k) != right.nearest2[p[k].point];
    answers_free(&right);
    free(p);
    return (double)wrong / n;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 20000, 1000, MANY);
    const double c = 1.5;
    print_header(&e, "name n one more twice fitted wrong");
    for (int d = 0; d < distribution_count; d++) {
        struct points p = generate(&distributions[d], n, 1);
        row("grid_%s\t%u\t%.5g\t%.5g\t%.5g\t%.5g\t%.4g",
            distributions[d].name, n, squares(p, c, 1) / n,
            squares(p, c / 100, 1) / n, squares(p, c, 2) / n,
            fitted(p, c) / n, share_wrong(p));
        points_free(&p);
    }
    return 0;
}
