// The shortest arc that holds all points of a circle: all of it except
// the widest gap between two points that follow each other.
#include "common/fail.h"
#include "exercise.h"
#include <stdlib.h>
#include <string.h>

//- solution
static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

//- starter
//- end
struct arc shortest_arc(const double *x, uint32_t n)
{
    //- solution
    double *sorted = allocate(n, sizeof *sorted);
    memcpy(sorted, x, n * sizeof *sorted);
    qsort(sorted, n, sizeof *sorted, by_value);
    double widest = sorted[0] + 1 - sorted[n - 1]; // across the border
    double start = sorted[0];
    for (uint32_t i = 1; i < n; i++)
        if (sorted[i] - sorted[i - 1] > widest) {
            widest = sorted[i] - sorted[i - 1];
            start = sorted[i];
        }
    free(sorted);
    return (struct arc){start, 1 - widest};
    //- starter
    // // Your turn. So far: all the way round, wherever they are.
    // return (struct arc){x[0], 1};
    //- end
}
