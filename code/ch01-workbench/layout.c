//> Measure what a point's layout costs
// One query point asks a hundred thousand points for their distance,
// and counts those within a radius: the same loop over three layouts of
// the points, and once more with a square root in it.
//
//     layout [POINTS [TRIALS]]
#include "common/argument.h"
#include "common/clock.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/geometry.h"
#include "common/report.h"
#include <stdio.h>
#include <stdlib.h>

//> Lay the points out in three ways
struct record { // as a program about cities would have them
    char name[32];
    long population;
    double x, y;
    double elevation;
};

struct place {
    double x, y;
};

struct layouts {
    struct record *records;
    struct place *pairs;
    struct points arrays;
    double x, y, radius; // the query
    long within;         // the answer
};
//<

//> Count the points within a radius
static void over_arrays(void *context)
{
    struct layouts *l = context;
    const double *x = l->arrays.x, *y = l->arrays.y;
    long within = 0;
    for (uint32_t j = 0; j < l->arrays.n; j++)
        within +=
            distance2(l->x - x[j], l->y - y[j]) < l->radius * l->radius;
    l->within = within;
}
//<

//> Count them in the other two layouts
static void over_records(void *context)
{
    struct layouts *l = context;
    long within = 0;
    for (uint32_t j = 0; j < l->arrays.n; j++)
        within +=
            distance2(l->x - l->records[j].x, l->y - l->records[j].y) <
            l->radius * l->radius;
    l->within = within;
}

static void over_pairs(void *context)
{
    struct layouts *l = context;
    long within = 0;
    for (uint32_t j = 0; j < l->arrays.n; j++)
        within +=
            distance2(l->x - l->pairs[j].x, l->y - l->pairs[j].y) <
            l->radius * l->radius;
    l->within = within;
}
//<

//> Count them by their distance itself
static void with_root(void *context)
{
    struct layouts *l = context;
    const double *x = l->arrays.x, *y = l->arrays.y;
    long within = 0;
    for (uint32_t j = 0; j < l->arrays.n; j++)
        within += sqrt(distance2(l->x - x[j], l->y - y[j])) < l->radius;
    l->within = within;
}
//<

int main(int argc, char **argv)
{
    fail_as("layout");
    uint32_t n = argument(argc, argv, 1, "POINTS", 100000, 1, MANY);
    int trials = argument(argc, argv, 2, "TRIALS", 101, 1, MANY);

    //> Fill the three layouts with the same points
    struct layouts l = {.x = 0.5, .y = 0.5, .radius = 0.25};
    l.arrays = generate(find_distribution("uniform"), n, 1);
    l.records = allocate(n, sizeof *l.records);
    l.pairs = allocate(n, sizeof *l.pairs);
    for (uint32_t j = 0; j < n; j++) {
        l.pairs[j] = (struct place){l.arrays.x[j], l.arrays.y[j]};
        l.records[j] = (struct record){
            .population = j, .x = l.arrays.x[j], .y = l.arrays.y[j]};
    }
    //<

    //> Time the four loops in turn
    struct trial versions[] = {{.work = over_records, .context = &l},
                               {.work = over_pairs, .context = &l},
                               {.work = over_arrays, .context = &l},
                               {.work = with_root, .context = &l}};
    const char *names[] = {"records", "pairs", "arrays", "root"};
    time_in_turn(trials, versions, 4);

    report_provenance(stdout);
    puts("name\tbytes\tns\tns_q1\tns_q3");
    for (int v = 0; v < 4; v++)
        printf("%s\t%zu\t%.4g\t%.4g\t%.4g\n", names[v],
               v == 0   ? sizeof(struct record)
               : v == 1 ? sizeof(struct place)
                        : 2 * sizeof(double),
               versions[v].summary.median / n,
               versions[v].summary.q1 / n, versions[v].summary.q3 / n);
    //<
    free(l.records);
    free(l.pairs);
    points_free(&l.arrays);
    return 0;
}
//<
