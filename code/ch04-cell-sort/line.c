//> Search a line
// All numbers: n steps. Sorted: log n and one for each result. Bins:
// one for each bin and each number that the interval meets.
#include "ch04-cell-sort/line.h"
#include "common/allocate.h"
#include <stdlib.h>
#include <string.h>

//> Look at all numbers
uint32_t scan_between(const double *x, uint32_t n, double a, double b,
                      double *found)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < n; i++) {
        found[count] = x[i]; // and is overwritten if it is not in
        count += (a <= x[i]) & (x[i] < b);
    }
    return count;
}
//<

//> Sort, and search by halves
static int compare_numbers(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

void sort_numbers(double *x, uint32_t n)
{
    qsort(x, n, sizeof *x, compare_numbers);
}

//> Halve until nothing is open
// The first place whose number is not below a; n if there is none.
static uint32_t place_of(const double *x, uint32_t n, double a)
{
    uint32_t low = 0, high = n;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (x[middle] < a)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}
//<

//> Take the numbers from there on
uint32_t sorted_between(const double *x, uint32_t n, double a, double b,
                        double *found)
{
    uint32_t count = 0;
    for (uint32_t s = place_of(x, n, a); s < n && x[s] < b; s++)
        found[count++] = x[s];
    return count;
}
//<
//<

//> Sort numbers into bins
struct bins bins_make(const double *x, uint32_t n, double c)
{
    double low = x[0], high = x[0];
    for (uint32_t i = 1; i < n; i++) {
        low = fmin(low, x[i]);
        high = fmax(high, x[i]);
    }
    struct bins bins = {
        .axis = axis_cut(low, high, INFINITY, cells_for(n, c))};
    const uint32_t m = bins.axis.count;
    bins.start = allocate((size_t)m + 1, sizeof *bins.start);
    bins.x = allocate(n, sizeof *bins.x);

    uint32_t *next = bins.start + 1; // the start of the next bin
    memset(bins.start, 0, ((size_t)m + 1) * sizeof *bins.start);
    //> Count the numbers of every bin
    for (uint32_t i = 0; i < n; i++)
        next[axis_cell(&bins.axis, x[i])]++;
    //<
    //> Scan the counts of the bins
    uint32_t sum = 0;
    for (uint32_t k = 0; k < m; k++) {
        uint32_t count = next[k];
        next[k] = sum;
        sum += count;
    }
    //<
    //> Place the numbers in their bins
    for (uint32_t i = 0; i < n; i++)
        bins.x[next[axis_cell(&bins.axis, x[i])]++] = x[i];
    //<
    return bins;
}
//<

void bins_free(struct bins *bins)
{
    axis_free(&bins->axis);
    free(bins->start);
    free(bins->x);
    *bins = (struct bins){0};
}

//> Query the bins
uint32_t bins_between(const struct bins *bins, double a, double b,
                      double *found)
{
    const struct axis *axis = &bins->axis;
    double low = axis->border[0], high = axis->border[axis->count];
    if (b <= a || b <= low || high < a)
        return 0;
    uint32_t first = axis_cell(axis, fmax(a, low));
    uint32_t last = axis_cell(axis, fmin(b, high));
    uint32_t begin = bins->start[first], end = bins->start[last + 1];
    return scan_between(bins->x + begin, end - begin, a, b, found);
}
//<
//<
