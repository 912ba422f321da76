// Tests of the search of blocks: the least distances, and the time,
// beside that of a search cell by cell.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static struct sorted sorted;
static uint32_t n, *cell_of;
static double *nearest2;

// One in so many cells has points.
static uint32_t one_in = 1;

// Cells of fewest to most points. They lie on a lattice, so that
// distances tie, or anywhere in their cells.
static void lay(uint32_t columns, uint32_t rows, uint32_t fewest,
                uint32_t most, bool lattice, uint64_t seed)
{
    struct random random = {seed};
    const uint32_t cells = columns * rows;
    uint32_t *start = kit_input("start", cells + 1, sizeof *start);
    n = 0;
    for (uint32_t k = 0; k < cells; k++) {
        start[k] = n;
        if (random_bits(&random) % one_in == 0)
            n += fewest + random_bits(&random) % (most - fewest + 1);
    }
    start[cells] = n;
    double *x = kit_input("x", n, sizeof *x);
    double *y = kit_input("y", n, sizeof *y);
    cell_of = kit_input("cells of places", n, sizeof *cell_of);
    for (uint32_t k = 0; k < cells; k++)
        for (uint32_t s = start[k]; s < start[k + 1]; s++) {
            const double u = random_uniform(&random);
            const double v = random_uniform(&random);
            cell_of[s] = k;
            x[s] = k % columns + (lattice ? floor(4 * u) / 4 : u);
            y[s] = k / columns + (lattice ? floor(4 * v) / 4 : v);
        }
    sorted = (struct sorted){columns, rows, start, x, y};
    nearest2 = kit_output("nearest2", n, sizeof *nearest2);
    kit_given("%u points in %u by %u cells", n, columns, rows);
}

// ---- answers -------------------------------------------------------

static int apart(uint32_t a, uint32_t b)
{
    return abs((int)a - (int)b);
}

static bool in_block(uint32_t s, uint32_t j)
{
    const uint32_t columns = sorted.columns;
    const uint32_t a = cell_of[s], b = cell_of[j];
    return apart(a % columns, b % columns) <= 1 &&
           apart(a / columns, b / columns) <= 1;
}

static double between(uint32_t s, uint32_t j)
{
    const double dx = sorted.x[j] - sorted.x[s];
    const double dy = sorted.y[j] - sorted.y[s];
    return dx * dx + dy * dy;
}

// The nearest in the block; n: none.
static uint32_t nearest_to(uint32_t s)
{
    uint32_t best = n;
    for (uint32_t j = 0; j < n; j++)
        if (j != s && in_block(s, j) &&
            (best == n || between(s, j) < between(s, best)))
            best = j;
    return best;
}

static const char *tell_cell(uint32_t s)
{
    return kit_text("place %u, column %u, row %u", s,
                    cell_of[s] % sorted.columns,
                    cell_of[s] / sorted.columns);
}

static const char *cause(uint32_t s, uint32_t right)
{
    if (nearest2[s] == 0)
        return "A point is not its own neighbor. Or is it left in a "
               "buffer from the block before?";
    if (isnan(nearest2[s]))
        return "Infinity less infinity is not a number, and no "
               "comparison with it is true.";
    for (uint32_t j = 0; j < n; j++)
        if (nearest2[s] == between(s, j) && !in_block(s, j))
            return kit_text("This is the distance to %s, which is not "
                            "in the block: at the left and right edges "
                            "a block has fewer columns.",
                            tell_cell(j));
    if (right == n)
        return "No other point is in the block: INFINITY. What fills "
               "the last lanes must not be near.";
    if (nearest2[s] < between(s, right))
        return "No point of the block is so near. Is something left "
               "in a buffer from the block before?";
    return kit_text("The nearest is at %s. Does the search go through "
                    "all points of the block, also the last ones of "
                    "it, and does each lane take part in the end?",
                    tell_cell(right));
}

static void check(void)
{
    CALL(STUDENT(nearest_in_block)(&sorted, nearest2));
    for (uint32_t s = 0; s < n; s++) {
        const uint32_t best = nearest_to(s);
        const double right = best == n ? INFINITY : between(s, best);
        if (nearest2[s] != right)
            WRONG(.where = tell_cell(s),
                  .expected = kit_text("%.17g", right),
                  .found = kit_text("%.17g", nearest2[s]),
                  .cause = cause(s, best));
    }
    kit_next_case();
}

static void even(uint64_t seed)
{
    lay(12, 12, 2, 6, false, seed);
    check();
    lay(9, 14, 1, 3, false, seed);
    check();
}

static void uneven(uint64_t seed)
{
    lay(20, 20, 0, 1, false, seed);
    check();
    lay(5, 4, 0, 64, false, seed);
    check();
    lay(10, 10, 0, 5, true, seed);
    check();
    one_in = 12;
    lay(9, 60, 1, 2, false, seed);
    check();
    one_in = 1;
}

static void small(uint64_t seed)
{
    for (uint32_t k = 0; k < 16; k++) {
        lay(1 + k % 4, 1 + k / 4, 0, 1 + k % 3 * 2, false, seed + k);
        check();
    }
}

// ---- time ----------------------------------------------------------

static void theirs(void)
{
    CALL(STUDENT(nearest_in_block)(&sorted, nearest2));
}

static double search_cell(uint32_t s, uint32_t k, double best)
{
    for (uint32_t j = sorted.start[k]; j < sorted.start[k + 1]; j++) {
        const double d2 = between(s, j);
        if (d2 < best && j != s)
            best = d2;
    }
    return best;
}

// Inside of the grid only: less work than is asked for.
static void cell_by_cell(void)
{
    const uint32_t columns = sorted.columns;
    CALL(for (uint32_t k = columns + 1;
              k + columns + 1 < columns * sorted.rows;
              k++) for (uint32_t s = sorted.start[k];
                        s < sorted.start[k + 1]; s++) {
        double best = INFINITY;
        for (uint32_t r = k - columns; r <= k + columns; r += columns)
            for (uint32_t c = r - 1; c <= r + 1; c++)
                best = search_cell(s, c, best);
        nearest2[s] = best;
    });
}

static void in_time(uint64_t seed)
{
    uneven(seed);
    const uint32_t side = kit_is_sanitized() ? 10 : 250;
    lay(side, side, 0, 8, false, seed);
    double ratio =
        kit_race((struct kit_race){theirs, cell_by_cell, .cores = 1});
    kit_bands(
        ratio,
        (struct kit_band[]){{0.63, 6}, {0.75, 4}, {0.88, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "five eighths of a search cell by cell",
            .found = kit_text("%.2f of it", ratio),
            .cause = "All queries of a cell have the same block. Find "
                     "its spans once, copy them, and let lanes go "
                     "through the copy without a branch."});
}

const struct kit_test kit_tests[] = {
    {"even", 2, "a few points in each cell", even},
    {"uneven", 1, "empty cells, full cells, and ties", uneven},
    {"small", 1, "grids no larger than a block", small},
    {"time", 6, "faster than cell by cell", in_time},
    {0},
};
