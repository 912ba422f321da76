// The pairs of the triangular loop and their numbers. Counted from the
// end, the rows have 1, 2, 3, ... pairs, and the triangular numbers say
// where each begins; a square root finds the row, up to rounding.
#include "exercise.h"
#include <math.h>

uint64_t number_of_pair(uint32_t n, uint32_t i, uint32_t j)
{
    //- solution
    return (uint64_t)i * (2 * (uint64_t)n - i - 1) / 2 + (j - i - 1);
    //- starter
    // // Your turn. So far: the numbers of a full square.
    // return i * n + j;
    //- end
}

//- solution
// Pairs in the last t rows that have any.
static uint64_t triangle(uint64_t t)
{
    return t * (t + 1) / 2;
}

//- starter
//- end
struct pair pair_of_number(uint32_t n, uint64_t number)
{
    //- solution
    uint64_t behind = triangle(n - 1) - 1 - number;
    uint64_t t = (uint64_t)((sqrt(8.0 * behind + 1) - 1) / 2);
    while (triangle(t) > behind)
        t--;
    while (triangle(t + 1) <= behind)
        t++;
    return (struct pair){(uint32_t)(n - 2 - t),
                         (uint32_t)(n - 1 - (behind - triangle(t)))};
    //- starter
    // // Your turn. So far: of a full square, too.
    // return (struct pair){number / n, number % n};
    //- end
}
