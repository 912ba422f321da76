// Trace the lanes of a vector.
// One row of a picture as a vector. A row of the table for every step:
// what each lane does, never packed, and behind a gap again, packed
// after every EVERY steps: 2 is useful work, 1 work for nothing, 0 no
// lane at all.
//     lanes [EVERY [LIMIT]]
#include "ch06-pack-scan/escape.h"
#include "common/experiment.h"
#include "common/report.h"

enum { WIDTH = 240, ROW = 66, GAP = 16 };

// Lane i works for point[i], which takes steps[point[i]] steps.
static int work(const uint32_t *point, uint32_t n, uint32_t i,
                const double *steps, uint32_t step)
{
    return i >= n ? 0 : steps[point[i]] > step ? 2 : 1;
}

static void print_head(void)
{
    report_provenance(stdout);
    for (int column = 0; column < 2 * WIDTH + GAP; column++)
        printf("%sc%d", column ? "\t" : "", column);
    row_end();
}

static void print_lanes(const uint32_t *all, const uint32_t *packed,
                        uint32_t n, const double *steps, uint32_t step)
{
    for (uint32_t i = 0; i < WIDTH; i++)
        printf("%d\t", work(all, WIDTH, i, steps, step));
    for (uint32_t i = 0; i < GAP; i++)
        printf("0\t");
    for (uint32_t i = 0; i < WIDTH; i++)
        printf("%d%c", work(packed, n, i, steps, step),
               i < WIDTH - 1 ? '\t' : '\n');
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t every = parameter(&e, "EVERY", 8, 1, MANY);
    uint32_t limit = parameter(&e, "LIMIT", 64, 1, MANY);
    const struct primitives *p = primitives(isa_chosen());
    struct points c = picture(WIDTH, WIDTH / 4 * 3);
    struct points row = {WIDTH, c.x + ROW * WIDTH, c.y + ROW * WIDTH};
    struct lanes lanes = lanes_allocate(WIDTH);
    double steps[WIDTH];
    escape(p, row, limit, every, &lanes, steps);
    uint32_t all[WIDTH], packed[WIDTH], n = WIDTH;
    for (uint32_t i = 0; i < WIDTH; i++)
        all[i] = packed[i] = i;
    print_head();
    for (uint32_t step = 0; step < limit; step++) {
        uint8_t inside[WIDTH];
        for (uint32_t i = 0; i < n; i++)
            inside[i] = steps[packed[i]] > step;
        if (step > 0 && step % every == 0)
            n = p->pack(packed, packed, inside, n);
        print_lanes(all, packed, n, steps, step);
    }
}
