// Tests of the cell sort by buckets: order, against a sort by
// comparisons, and time, against two rounds of moves whose goals are
// known beforehand.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

static const uint32_t *cell; // of the case

static uint32_t *draw(uint32_t n, uint32_t cells, uint64_t seed)
{
    struct random random = {seed};
    uint32_t *drawn = kit_input("cell", n, sizeof *drawn);
    for (uint32_t i = 0; i < n; i++)
        drawn[i] = random_bits(&random) % cells;
    cell = drawn;
    kit_given("%u points in %u cells", n, cells);
    return drawn;
}

static int by_cell(const void *a, const void *b)
{
    uint32_t i = *(const uint32_t *)a, j = *(const uint32_t *)b;
    if (cell[i] != cell[j])
        return cell[i] < cell[j] ? -1 : 1;
    return (i > j) - (i < j);
}

// The first point that stands nowhere, or n.
static uint32_t missing(uint32_t n, const uint32_t *point)
{
    bool *there = kit_input("who is there", n, sizeof *there);
    memset(there, false, n);
    for (uint32_t s = 0; s < n; s++)
        if (point[s] < n)
            there[point[s]] = true;
    uint32_t i = 0;
    while (i < n && there[i])
        i++;
    return i;
}

static const char *cause(uint32_t n, const uint32_t *point)
{
    bool cells_rise = true, low_rise[16];
    memset(low_rise, true, sizeof low_rise);
    uint32_t lost = missing(n, point);
    if (lost < n)
        return kit_text("Point %u stands nowhere: two were put into "
                        "one place, or it was not moved in one of the "
                        "rounds.",
                        lost);
    for (uint32_t s = 1; s < n; s++) {
        uint32_t before = cell[point[s - 1]], here = cell[point[s]];
        cells_rise &= before <= here;
        for (int bits = 4; bits < 16; bits++)
            low_rise[bits] &=
                before % (1u << bits) <= here % (1u << bits);
    }
    if (cells_rise)
        return "The cells are right, and the order in a cell is not: "
               "each round must keep the order of what it finds "
               "equal.";
    if (memchr(low_rise + 4, true, 12))
        return "The round that decides must come last, and it is that "
               "by the upper bits.";
    return "Not all bits of the cell have had their say, or a round "
           "did not keep the order of the round before.";
}

static void check(uint32_t n, uint32_t cells)
{
    uint32_t *point = kit_output("point", n, sizeof *point);
    CALL(STUDENT(sort_points)(n, cells, cell, point));
    uint32_t *right = kit_input("right", n, sizeof *right);
    for (uint32_t i = 0; i < n; i++)
        right[i] = i;
    qsort(right, n, sizeof *right, by_cell);
    for (uint32_t s = 0; s < n; s++)
        if (point[s] != right[s])
            WRONG(.where = kit_text("place %u", s),
                  .expected = kit_text("point %u of cell %u", right[s],
                                       cell[right[s]]),
                  .found =
                      point[s] < n
                          ? kit_text("point %u of cell %u", point[s],
                                     cell[point[s]])
                          : kit_text("%u, which is no point", point[s]),
                  .cause = cause(n, point));
    kit_next_case();
}

static void right(uint64_t seed)
{
    draw(3000, 1000, seed);
    check(3000, 1000);
    draw(3000, 3000000, seed);
    check(3000, 3000000);
    draw(20000, (1 << 24) - 1, seed);
    check(20000, (1 << 24) - 1);
}

static void crowded(uint64_t seed)
{
    draw(2000, 1, seed);
    check(2000, 1);
    draw(2000, 5, seed);
    check(2000, 5);
    uint32_t *drawn = draw(2000, 1000000, seed);
    for (uint32_t i = 0; i < 2000; i++)
        drawn[i] = 999999 - drawn[i] % 3 * 70000;
    check(2000, 1000000);
}

static void few(uint64_t seed)
{
    for (uint32_t n = 0; n <= 5; n++) {
        draw(n, 100000, seed + n);
        check(n, 100000);
    }
}

// ---- time ----------------------------------------------------------

enum { MANY = 4096000, CELLS = 16000000, STREAMS = 2048 };
static uint32_t *found;

// Streams that are written from front to back, in turn: a matrix that
// is turned around, once as records and once as numbers.
static void move_twice(void)
{
    enum { LENGTH = MANY / STREAMS };
    uint64_t *records = malloc(MANY * sizeof *records);
    for (uint32_t k = 0; k < LENGTH; k++)
        for (uint32_t s = 0; s < STREAMS; s++) {
            uint32_t i = k * STREAMS + s;
            uint32_t stream = (s * 1021 + k) % STREAMS;
            records[stream * LENGTH + k] = (uint64_t)cell[i] << 32 | i;
        }
    for (uint32_t k = 0; k < LENGTH; k++)
        for (uint32_t s = 0; s < STREAMS; s++) {
            uint32_t stream = (s * 1021 + k) % STREAMS;
            found[stream * LENGTH + k] =
                (uint32_t)records[k * STREAMS + s];
        }
    free(records);
}

static void ours(void)
{
    CALL(move_twice());
}

static void theirs(void)
{
    CALL(STUDENT(sort_points)(MANY, CELLS, cell, found));
}

static void in_time(uint64_t seed)
{
    draw(20000, 3000000, seed);
    check(20000, 3000000);
    draw(MANY, CELLS, seed);
    found = kit_output("point", MANY, sizeof *found);
    double ratio =
        kit_race((struct kit_race){theirs, ours, .cores = 1});
    kit_bands(
        ratio, (struct kit_band[]){{1.8, 6}, {2.1, 4}, {2.4, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "at most 1.8 times the time of moving all "
                        "points twice, in streams",
            .found = kit_text("%.1f times", ratio),
            .cause = "With millions of counts, every count and "
                     "every place is a miss. Which part of the "
                     "cell has so few values that their counts "
                     "stay in the first cache?"});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "the order, by cell and by number", right},
    {"crowded", 1, "few cells, or a single one", crowded},
    {"few", 1, "from no point to five", few},
    {"time", 6, "four million points in sixteen million cells",
     in_time},
    {0},
};
