//> Lose counts
// Counts points in some 576 cells without any care: in groups of lanes
// that first read all counts, then write them all, and on two threads.
// The threads race, on purpose, like those of chapter 3. Prints what
// should have been counted in every cell, and what was.
//
//     lost-counts [POINTS]
#include "ch05-collisions/home.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/report.h"
#include <stdlib.h>
#include <string.h>

enum { CELLS = 576, MOST_LANES = 1024, WAYS = 5, ROUNDS = 100 };

//> Count in lanes and hope
static void count_in_lanes(const uint32_t *home, uint32_t n,
                           uint32_t lanes, uint32_t *count)
{
    uint32_t seen[MOST_LANES];
    for (uint32_t i = 0; i + lanes <= n; i += lanes) {
        for (uint32_t k = 0; k < lanes; k++)
            seen[k] = count[home[i + k]];
        for (uint32_t k = 0; k < lanes; k++)
            count[home[i + k]] = seen[k] + 1;
    }
}
//<

//> Count on two threads and hope
// So many rounds that both threads are sure to be at it together.
static void count_racing(const uint32_t *home, uint32_t n,
                         uint32_t *count)
{
#pragma omp parallel num_threads(2)
    for (int round = 0; round < ROUNDS; round++)
#pragma omp for
        for (uint32_t i = 0; i < n; i++)
            count[home[i]]++;
}
//<

//> Print what every cell was said to have
// With names, so that the text can quote the first row, the sums. Of
// the threads, the mean of their rounds.
static void print_counts(uint32_t m, uint32_t *count)
{
    const double rounds[WAYS] = {1, 1, 1, 1, ROUNDS};
    printf("name\tright\tlanes8\tlanes64\tlanes1024\tthreads2\nall");
    for (int way = 0; way < WAYS; way++) {
        uint64_t sum = 0;
        for (uint32_t cell = 0; cell < m; cell++)
            sum += count[way * m + cell];
        printf("\t%.9g", sum / rounds[way]);
    }
    for (uint32_t cell = 0; cell < m; cell++) {
        printf("\ncell_%u", cell);
        for (int way = 0; way < WAYS; way++)
            printf("\t%.9g", count[way * m + cell] / rounds[way]);
    }
    puts("");
}
//<

int main(int argc, char **argv)
{
    fail_as("lost-counts");
    uint32_t n = argument(argc, argv, 1, "POINTS", 1 << 20, MOST_LANES,
                          UINT32_MAX / ROUNDS);
    n -= n % MOST_LANES; // groups without a rest
    struct points points =
        generate(find_distribution("clustered"), n, 2);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, (double)n / CELLS);
    const uint32_t m = grid_cells(&grid);
    uint32_t *home = allocate(n, sizeof *home);
    uint32_t *count = allocate((size_t)WAYS * m, sizeof *count);
    memset(count, 0, (size_t)WAYS * m * sizeof *count);
    find_homes(&grid, points, 0, n, home);
    count_in_lanes(home, n, 1, count);
    count_in_lanes(home, n, 8, count + m);
    count_in_lanes(home, n, 64, count + 2 * m);
    count_in_lanes(home, n, 1024, count + 3 * m);
    count_racing(home, n, count + 4 * m);
    report_provenance(stdout);
    print_counts(m, count);
    free(count);
    free(home);
    grid_free(&grid);
    points_free(&points);
    return 0;
}
//<
