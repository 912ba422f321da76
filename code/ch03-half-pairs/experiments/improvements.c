// Counts how often a best improves while the triangle is walked down on
// one thread: points at random, and houses along a street. Beside the
// counts stands what is expected at random, the sum of 1/k for k from 1
// to n-1.
//     improvements [LARGEST]
#include "ch02-all-pairs/pair.h"
#include "common/experiment.h"

// How many of the two bests of a point a pair improves.
static int improve(double *near2, double *far2, double distance2)
{
    int improved = (distance2 < *near2) + (distance2 > *far2);
    *near2 = fmin(*near2, distance2);
    *far2 = fmax(*far2, distance2);
    return improved;
}

static uint64_t improvements(struct points p)
{
    double *near2 = take(p.n, sizeof *near2);
    double *far2 = take(p.n, sizeof *far2);
    uint64_t improved = 0;
    for (uint32_t i = 0; i < p.n; i++)
        near2[i] = INFINITY;
    for (uint32_t i = 0; i < p.n; i++)
        for (uint32_t j = i + 1; j < p.n; j++) {
            double dx = p.x[j] - p.x[i], dy = p.y[j] - p.y[i];
            double d2 = dx * dx + dy * dy;
            improved += improve(&near2[i], &far2[i], d2);
            improved += improve(&near2[j], &far2[j], d2);
        }
    return improved;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t largest = parameter(&e, "LARGEST", 4000, 2, MANY);
    puts("points   a best, random   expected   a best, street");
    for (uint32_t n = 500; n <= largest; n *= 2) {
        struct points p = uniform_question(STANDARD, n, 1).points;
        double expected = 0, bests = 2.0 * n;
        for (uint32_t k = 1; k < n; k++)
            expected += 1.0 / k;
        double uniform = improvements(p) / bests;
        for (uint32_t i = 0; i < n; i++) {
            p.x[i] = i; // the distances are whole numbers
            p.y[i] = 0;
        }
        double street = improvements(p) / bests;
        row("%6u %16.2f %10.2f %16.2f", n, uniform, expected, street);
        forget();
    }
}
