// Tests of the count: against a look at every point, and how many were
// looked at.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

static uint32_t n, columns, *start;
static double *x, *y, box[4];
static struct cell_block block;
static uint64_t *looks;
static uint32_t *found;

static bool is_in(uint32_t s)
{
    return box[0] <= x[s] && x[s] <= box[1] && box[2] <= y[s] &&
           y[s] <= box[3];
}

bool is_in_box(uint32_t place)
{
    ++*looks;
    return is_in(place);
}

static void draw_box(struct random *random, double size)
{
    for (int k = 0; k < 2; k++) {
        box[2 * k] = (1 - size) * random_uniform(random);
        box[2 * k + 1] = box[2 * k] + size * random_uniform(random);
    }
    block = (struct cell_block){
        (uint32_t)(box[0] * columns), (uint32_t)(box[1] * columns),
        (uint32_t)(box[2] * columns), (uint32_t)(box[3] * columns)};
}

// Cell by cell, per_cell points in each, or fewer.
static void prepare(uint32_t side, uint32_t per_cell, double size,
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    columns = side;
    const uint32_t m = side * side, most = m * per_cell;
    start = kit_input("start", m + 1, sizeof *start);
    x = kit_input("x", most, sizeof *x);
    y = kit_input("y", most, sizeof *y);
    looks = kit_output("the count", 1, sizeof *looks);
    found = kit_output("the answer", 1, sizeof *found);
    n = 0;
    for (uint32_t cell = 0; cell < m; cell++) {
        start[cell] = n;
        const uint32_t count = random_bits(&random) % (per_cell + 1);
        for (uint32_t k = 0; k < count; k++, n++) {
            x[n] = (cell % side + random_uniform(&random)) / side;
            y[n] = (cell / side + random_uniform(&random)) / side;
        }
    }
    start[m] = n;
    draw_box(&random, size);
    kit_given("%u points in %u columns and rows, a block of columns "
              "%u to %u and rows %u to %u",
              n, side, block.first_column, block.last_column,
              block.first_row, block.last_row);
}

static bool is_inner(uint32_t s)
{
    const uint32_t i = (uint32_t)(x[s] * columns);
    const uint32_t j = (uint32_t)(y[s] * columns);
    return block.first_column < i && i < block.last_column &&
           block.first_row < j && j < block.last_row;
}

static bool in_block(uint32_t s)
{
    const uint32_t i = (uint32_t)(x[s] * columns);
    const uint32_t j = (uint32_t)(y[s] * columns);
    return block.first_column <= i && i <= block.last_column &&
           block.first_row <= j && j <= block.last_row;
}

static void ask(void)
{
    CALL(*looks = 0;
         *found = STUDENT(count_in_box)(start, columns, block));
    uint32_t right = 0;
    for (uint32_t s = 0; s < n; s++)
        right += is_in(s);
    if (*found != right)
        WRONG(.expected = kit_text("%u points in the box", right),
              .found = kit_text("%u", *found),
              .cause = *found > right
                           ? "A cell at the border was taken unseen, "
                             "or twice."
                           : "Some cells of the block were left out.");
}

static void right(uint64_t seed)
{
    for (int trial = 0; trial < 60; trial++) {
        prepare(8, 6, 0.9, seed + trial);
        ask();
    }
}

static void thin(uint64_t seed)
{
    for (int trial = 0; trial < 60; trial++) {
        prepare(5, 6, 0.3, seed + trial);
        ask();
    }
}

static void count(uint64_t seed)
{
    double worst = 0;
    for (int trial = 0; trial < 20; trial++) {
        prepare(60, 6, 0.95, seed + trial);
        ask();
        double border = 1;
        for (uint32_t s = 0; s < n; s++)
            border += in_block(s) && !is_inner(s);
        worst = fmax(worst, *looks / border);
    }
    kit_bands(worst, (struct kit_band[]){{1, 6}, {2, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "no look at a point of an inner cell",
                  .found = kit_text("%.1f times as many as are in "
                                    "border cells",
                                    worst),
                  .cause = "The points of inner cells are counted by "
                           "the difference of two starts."});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "points in boxes of all sizes", right},
    {"thin", 2, "blocks of few columns and rows", thin},
    {"count", 6, "only points at the border looked at", count},
    {0},
};
