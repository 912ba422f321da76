//> Select by rank
// All passes are without branches that could be guessed wrong: what is
// not wanted is written, too, and then overwritten.
#include "ch12-range-queries/select.h"
#include "common/min_max.h"
#include <math.h>

//> Partition the numbers by a pivot
// x[0 .. n-1] and other[] change roles: the lower ones stay in x, the
// greater ones go to other. Equal ones are only counted.
struct sides {
    uint32_t lower, equal, greater;
};

static struct sides partition(double *x, uint32_t n, double pivot,
                              double *other)
{
    uint32_t lower = 0, greater = 0;
    for (uint32_t i = 0; i < n; i++) {
        const double value = x[i];
        x[lower] = value;
        other[greater] = value;
        lower += value < pivot;
        greater += value > pivot;
    }
    return (struct sides){lower, n - lower - greater, greater};
}
//<

//> Take the middle of three
static double middle_of_three(double a, double b, double c)
{
    return MAX(MIN(a, b), MIN(MAX(a, b), c));
}
//<

//> Find the number of a rank
// The pivot is the median of three that a simple generator picks.
static double find(double *x, uint32_t n, uint32_t rank, double *other)
{
    uint32_t random = n;
    for (;;) {
        double pick[3];
        for (int k = 0; k < 3; k++) {
            random = random * 1664525 + 1013904223;
            pick[k] = x[(uint64_t)random * n >> 32];
        }
        const double pivot = middle_of_three(pick[0], pick[1], pick[2]);
        const struct sides sides = partition(x, n, pivot, other);
        if (rank < sides.lower) {
            n = sides.lower;
        } else if (rank < sides.lower + sides.equal) {
            return pivot;
        } else {
            double *swap = x;
            x = other;
            other = swap;
            rank -= sides.lower + sides.equal;
            n = sides.greater;
        }
    }
}
//<

//> Bound it by a sample
enum { FEW = 512, SAMPLE = 1024 };

struct bounds {
    double low, high;
};

static struct bounds bound(const double *x, uint32_t n, uint32_t rank,
                           double *room)
{
    const uint32_t m = MIN(n / 8, SAMPLE);
    const uint32_t gap = (uint32_t)(1.5 * sqrt(m)) + 1;
    const uint32_t middle = (uint64_t)rank * m / n;
    struct bounds bounds = {-INFINITY, INFINITY};
    for (int side = 0; side < 2; side++) {
        const uint32_t at = side ? middle + gap : middle - gap;
        if (at >= m) // or below 0
            continue;
        for (uint32_t k = 0; k < m; k++)
            room[k] = x[(uint64_t)k * n / m];
        *(side ? &bounds.high : &bounds.low) =
            find(room, m, at, room + m);
    }
    return bounds;
}
//<

//> Keep what is between the bounds
double select_rank(const double *x, uint32_t n, uint32_t rank,
                   double *room)
{
    struct bounds bounds = {-INFINITY, INFINITY};
    if (n > FEW)
        bounds = bound(x, n, rank, room);
    for (;;) {
        uint32_t below = 0, kept = 0;
        for (uint32_t i = 0; i < n; i++) {
            const double value = x[i];
            room[kept] = value;
            below += value < bounds.low;
            kept += (value >= bounds.low) & (value <= bounds.high);
        }
        if (rank >= below && rank - below < kept)
            return find(room, kept, rank - below, room + n);
        bounds = (struct bounds){-INFINITY, INFINITY}; // it missed
    }
}
//<
//<
