// Counts the points within a radius of one query: the same loop over
// three layouts of the points, and once more with a square root in it.
//     layout [POINTS [TRIALS]]
#include "common/experiment.h"

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

static void with_root(void *context)
{
    struct layouts *l = context;
    const double *x = l->arrays.x, *y = l->arrays.y;
    long within = 0;
    for (uint32_t j = 0; j < l->arrays.n; j++)
        within += sqrt(distance2(l->x - x[j], l->y - y[j])) < l->radius;
    l->within = within;
}

static struct layouts lay_out(uint32_t n)
{
    struct layouts l = {.x = 0.5,
                        .y = 0.5,
                        .radius = 0.25,
                        .arrays =
                            uniform_question(STANDARD, n, 1).points,
                        .records = take(n, sizeof *l.records),
                        .pairs = take(n, sizeof *l.pairs)};
    for (uint32_t j = 0; j < n; j++) {
        l.pairs[j] = (struct place){l.arrays.x[j], l.arrays.y[j]};
        l.records[j] = (struct record){
            .population = j, .x = l.arrays.x[j], .y = l.arrays.y[j]};
    }
    return l;
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t n = parameter(&e, "POINTS", 100000, 1, MANY);
    int trials = parameter(&e, "TRIALS", 101, 1, MANY);
    struct layouts l = lay_out(n);

    struct trial versions[] = {{over_records, &l},
                               {over_pairs, &l},
                               {over_arrays, &l},
                               {with_root, &l}};
    time_in_turn(trials, versions, 4);

    const size_t array = 2 * sizeof(double);
    print_header(&e, "name bytes ns:3");
    row_of_times(&versions[0], 1, n, "records\t%zu",
                 sizeof(struct record));
    row_of_times(&versions[1], 1, n, "pairs\t%zu",
                 sizeof(struct place));
    row_of_times(&versions[2], 1, n, "arrays\t%zu", array);
    row_of_times(&versions[3], 1, n, "root\t%zu", array);
}
