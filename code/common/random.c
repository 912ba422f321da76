//> Draw random numbers
// Only sums, products, quotients, square roots and comparisons, which
// every machine rounds alike: log and cos would not be the same
// everywhere, and neither would the points.
#include "common/random.h"
#include <math.h>

//> Draw random bits
uint64_t random_bits(struct random *random)
{
    uint64_t z = random->state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return z ^ z >> 31;
}
//<

//> Draw a uniform number
double random_uniform(struct random *random)
{
    return (random_bits(random) >> 11) * 0x1p-53;
}
//<

//> Draw a direction
void random_direction(struct random *random, double *x, double *y)
{
    double length2;
    do {
        *x = 2 * random_uniform(random) - 1;
        *y = 2 * random_uniform(random) - 1;
        length2 = *x * *x + *y * *y;
    } while (length2 > 1 || length2 == 0);
    *x /= sqrt(length2);
    *y /= sqrt(length2);
}
//<

//> Draw a waiting time without a logarithm
// Von Neumann (1951): a run of falling numbers has an odd length with
// just the right probability, exp of minus the first of them.
static double exponential(struct random *random)
{
    for (double whole = 0;; whole++) {
        double first = random_uniform(random), last = first, next;
        int length = 1;
        while ((next = random_uniform(random)) < last) {
            last = next;
            length++;
        }
        if (length % 2)
            return whole + first;
    }
}
//<

//> Draw a normal number
double random_normal(struct random *random)
{
    double x, y;
    random_direction(random, &x, &y);
    return sqrt(2 * exponential(random)) * x;
}
//<
//<
