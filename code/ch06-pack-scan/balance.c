//> Time packing, often and seldom
// The escape times of a picture, packed after every so many steps: the
// steps that all lanes did and the nanoseconds, for each useful step;
// with short vectors, one after another, and all points in one vector.
//
//     balance [TRIALS [WIDTH]]
#include "ch02-all-pairs/timing.h"
#include "ch06-pack-scan/escape.h"
#include "common/argument.h"
#include "common/fail.h"
#include "common/report.h"
#include <stdio.h>
#include <stdlib.h>

enum { LIMIT = 256, SHORT = 256 };

struct drawing {
    const struct primitives *p;
    struct points c;
    uint32_t every, length; // of the vectors
    struct lanes *lanes;
    double *steps;
    uint64_t done; // set by draw
};

//> Draw a picture, vector by vector
static void draw(void *context)
{
    struct drawing *d = context;
    d->done = 0;
    for (uint32_t i = 0; i < d->c.n; i += d->length) {
        uint32_t left = d->c.n - i;
        struct points some = {left < d->length ? left : d->length,
                              d->c.x + i, d->c.y + i};
        d->done +=
            escape(d->p, some, LIMIT, d->every, d->lanes, d->steps + i);
    }
}
//<

static void print_drawing(struct drawing in_short, uint32_t every,
                          int trials)
{
    in_short.every = every;
    struct drawing in_one = in_short;
    in_one.length = in_one.c.n;
    struct trial turns[] = {{.work = draw, .context = &in_short},
                            {.work = draw, .context = &in_one}};
    time_in_turn(trials, turns, 2);
    double useful = 0;
    for (uint32_t i = 0; i < in_one.c.n; i++)
        useful += in_one.steps[i];
    printf("every_%u\t%u\t%.5g\t%.5g", every, every,
           useful / in_one.c.n, in_one.done / useful);
    for (int t = 0; t < 2; t++)
        print_summary(&turns[t].summary, useful);
    puts("");
}

int main(int argc, char **argv)
{
    fail_as("balance", NULL);
    int trials = argument(argc, argv, 1, "TRIALS", 3, 1, MANY);
    uint32_t width = argument(argc, argv, 2, "WIDTH", 240, 4, 10000);
    struct points c = picture(width, width / 4 * 3);
    struct lanes lanes = lanes_allocate(c.n);
    struct drawing drawing = {
        .p = primitives(isa_chosen()),
        .c = c,
        .length = SHORT,
        .lanes = &lanes,
        .steps = allocate(c.n, sizeof(double)),
    };
    report_provenance(stdout);
    puts("name\tevery\tuseful\tdone"
         "\tshort_ns\tshort_ns_q1\tshort_ns_q3"
         "\tlong_ns\tlong_ns_q1\tlong_ns_q3");
    for (uint32_t every = 1; every < LIMIT; every *= 2) {
        print_drawing(drawing, every, trials);
        if (every >= 2 && every < LIMIT / 2)
            print_drawing(drawing, every / 2 * 3, trials);
    }
    print_drawing(drawing, LIMIT, trials); // that is, never
    free(drawing.steps);
    lanes_free(&lanes);
    points_free(&c);
    return 0;
}
//<
