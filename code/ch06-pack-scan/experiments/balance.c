// Time packing, often and seldom.
// The escape times of a picture, packed after every so many steps: the
// steps that all lanes did and the nanoseconds, for each useful step;
// with short vectors, one after another, and all points in one vector;
// and how many loops the short ones begin.
//     balance [TRIALS [WIDTH]]
#include "ch06-pack-scan/escape.h"
#include "common/experiment.h"

enum { LIMIT = 256, SHORT = 256 };

struct drawing {
    const struct primitives *p;
    struct points c;
    uint32_t every, length; // of the vectors
    struct lanes *lanes;
    double *steps;
    uint64_t done; // set by draw
};

// Draw a picture, vector by vector.
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

// Draw it with every interval, in turn.
// Intervals of 1, 2, 3, 4, 6, 8, 12, ... up to LIMIT, that is, never.
enum { INTERVALS = 16 };

static void intervals(uint32_t every[static INTERVALS])
{
    every[0] = 1;
    for (int k = 1; k < INTERVALS; k++)
        every[k] = k % 2 ? 2 << k / 2 : 3 << (k / 2 - 1);
}

// The loops that are begun for all points: one for a step, nine for a
// packing. A vector ends with the packing that finds all lanes done.
static double starts(const struct drawing *d)
{
    enum { OF_A_PACKING = 9 };
    double sum = 0;
    for (uint32_t i = 0; i < d->c.n; i += d->length) {
        uint32_t last = 0; // steps of its longest lane
        for (uint32_t j = i; j < d->c.n && j < i + d->length; j++)
            last = d->steps[j] > last ? (uint32_t)d->steps[j] : last;
        last = last < LIMIT ? last : LIMIT - 1;
        uint32_t packings = last / d->every + 1;
        uint32_t steps = packings * d->every;
        sum += steps < LIMIT ? steps : LIMIT;
        sum += OF_A_PACKING * packings;
    }
    return sum;
}

static void print_rows(const struct drawing *drawings,
                       const struct trial *turns)
{
    const struct points c = drawings->c;
    double useful = 0;
    for (uint32_t i = 0; i < c.n; i++)
        useful += drawings->steps[i];
    for (int d = 0; d < 2 * INTERVALS; d += 2)
        row_of_times(
            &turns[d], 2, useful, "every_%u\t%u\t%.5g\t%.5g\t%.4g",
            drawings[d].every, drawings[d].every, useful / c.n,
            drawings[d].done / useful, starts(&drawings[d]) / useful);
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    int trials = parameter(&e, "TRIALS", 3, 1, MANY);
    uint32_t width = parameter(&e, "WIDTH", 240, 4, 10000);
    struct points c = picture(width, width / 4 * 3);
    struct lanes lanes = lanes_allocate(c.n);
    uint32_t every[INTERVALS];
    intervals(every);
    struct drawing drawings[2 * INTERVALS];
    struct trial turns[2 * INTERVALS];
    double *steps = take(c.n, sizeof *steps);
    for (int d = 0; d < 2 * INTERVALS; d++) {
        drawings[d] = (struct drawing){.p = primitives(isa_chosen()),
                                       .c = c,
                                       .every = every[d / 2],
                                       .length = d % 2 ? c.n : SHORT,
                                       .lanes = &lanes,
                                       .steps = steps};
        turns[d] = (struct trial){draw, &drawings[d]};
    }
    time_in_turn(trials, turns, 2 * INTERVALS);
    print_header(&e,
                 "name every useful done starts short_ns:3 long_ns:3");
    print_rows(drawings, turns);
}
