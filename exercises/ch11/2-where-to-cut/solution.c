// Sorted, the middle value begins somewhere and ends somewhere: the two
// cuts nearest to the middle are there.
#include "exercise.h"
#include <stdlib.h>

//- solution
static int ascending(const void *one, const void *other)
{
    double a = *(const double *)one, b = *(const double *)other;
    return (a > b) - (a < b);
}

//- starter
//- end
uint32_t cut_in_two(double *value, uint32_t n)
{
    //- solution
    qsort(value, n, sizeof *value, ascending);
    uint32_t below = n / 2, up_to = n / 2;
    while (below > 0 && value[below - 1] == value[n / 2])
        below--;
    while (up_to < n && value[up_to] == value[n / 2])
        up_to++;
    if (below == 0)
        return up_to;
    if (up_to == n)
        return below;
    return n - below <= up_to ? below : up_to;
    //- starter
    // // Your turn: so far it cuts where the first number is.
    // uint32_t first = 0;
    // for (uint32_t k = 1; k < n; k++)
    //     first += value[k] < value[0];
    // return first;
    //- end
}
