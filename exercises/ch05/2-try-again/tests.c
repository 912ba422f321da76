// Tests of the histogram by rounds: counts for points apart, at random
// and in one cell, and the cycles, against rounds of four calls. The
// vector unit keeps its arrays to itself; where lanes collide, chance
// decides who stays.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"

// The vector unit, in the student's process.
static uint32_t *arrays[2]; // scratch and counts
static struct notes {
    uint64_t cycles;
    uint64_t calls[2]; // for scratch, for the counts
    struct random chance;
    uint32_t bad_lanes, bad_cell; // 0, or 1 more than what was wrong
} * notes;
static uint32_t cell_count;

// Whether the call is one that the vector unit understands; notes it.
static bool valid(enum array array, uint32_t lanes,
                  const uint32_t *cell)
{
    if (lanes < 1 || lanes > LANES) {
        notes->bad_lanes = lanes + 1;
        return false;
    }
    for (uint32_t l = 0; l < lanes; l++)
        if (cell[l] >= cell_count) {
            notes->bad_cell = cell[l] + 1;
            return false;
        }
    notes->cycles += STARTUP + lanes;
    notes->calls[array]++;
    return true;
}

void gather(enum array array, uint32_t lanes, const uint32_t *cell,
            uint32_t *to)
{
    if (!valid(array, lanes, cell))
        return;
    for (uint32_t l = 0; l < lanes; l++)
        to[l] = arrays[array][cell[l]];
}

void scatter(enum array array, uint32_t lanes, const uint32_t *cell,
             const uint32_t *from)
{
    if (!valid(array, lanes, cell))
        return;
    uint32_t order[LANES]; // shuffled: the last store stays
    for (uint32_t l = 0; l < lanes; l++) {
        uint32_t other = random_bits(&notes->chance) % (l + 1);
        order[l] = order[other];
        order[other] = l;
    }
    for (uint32_t l = 0; l < lanes; l++)
        arrays[array][cell[order[l]]] = from[order[l]];
}

// What the mistakes that we know would count in a cell: once a group,
// twice at most, all but once, and what is right.
struct tally {
    uint32_t right, once, twice, losers;
};

struct points_in {
    uint32_t n, *cell;
};

static uint32_t lanes_at(uint32_t n, uint32_t i)
{
    return n - i < LANES ? n - i : LANES;
}

// How many points of the group that begins at i are in this cell.
static uint32_t in_group(struct points_in points, uint32_t i,
                         uint32_t cell)
{
    uint32_t count = 0;
    for (uint32_t l = 0; l < lanes_at(points.n, i); l++)
        count += points.cell[i + l] == cell;
    return count;
}

static struct tally tally(struct points_in points, uint32_t cell)
{
    struct tally tally = {0};
    for (uint32_t i = 0; i < points.n; i += LANES) {
        uint32_t count = in_group(points, i, cell);
        tally.right += count;
        tally.once += count > 0;
        tally.twice += count > 1 ? 2 : count;
        tally.losers += count > 0 ? count - 1 : 0;
    }
    return tally;
}

static const char *cause(struct points_in points, uint32_t cell)
{
    struct tally right = tally(points, cell);
    uint32_t found = arrays[COUNTS][cell];
    if (notes->bad_lanes)
        return kit_text("A call had %u lanes: there are 1 to %u.",
                        notes->bad_lanes - 1, (uint32_t)LANES);
    if (notes->bad_cell)
        return kit_text("A call was about cell %u, and there is no "
                        "such cell.",
                        notes->bad_cell - 1);
    if (found == right.once)
        return "Every group counted this cell just once: do the losers "
               "get a round of their own, and does it read the counts "
               "again?";
    if (notes->calls[SCRATCH] == 0)
        return "The lanes signed in the counts themselves: what was "
               "counted is overwritten. They need the scratch array.";
    if (found == right.twice)
        return "Losers collide with each other, too: one more round "
               "is not enough, go on until none loses.";
    if (found == right.losers)
        return "Only the losers were counted: in each round the "
               "winners are counted, and the losers remain.";
    if (found < right.right)
        return "Some points were lost. Is each lane that reads "
               "another's number a loser, and is every loser's cell "
               "kept for the next round?";
    return "Some points were counted twice. Who has won does not take "
           "part in the next round.";
}

static struct points_in prepare(uint32_t n, uint32_t cells,
                                uint64_t seed)
{
    kit_given("%u points, %u cells", n, cells);
    cell_count = cells;
    struct random random = {seed};
    arrays[SCRATCH] = kit_output("the arrays", cells, sizeof(uint32_t));
    arrays[COUNTS] = kit_output("the arrays", cells, sizeof(uint32_t));
    for (uint32_t k = 0; k < cells; k++) {
        arrays[SCRATCH][k] = random_bits(&random) % LANES;
        arrays[COUNTS][k] = 0;
    }
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.chance = {seed + 1}};
    return (struct points_in){n,
                              kit_input("cell", n, sizeof(uint32_t))};
}

static struct points_in scattered(uint32_t n, uint32_t cells,
                                  uint64_t seed)
{
    struct points_in points = prepare(n, cells, seed);
    struct random random = {seed + 2};
    for (uint32_t i = 0; i < n; i++)
        points.cell[i] = random_bits(&random) % cells;
    return points;
}

static struct points_in in_one_cell(uint32_t n, uint32_t cells,
                                    uint64_t seed)
{
    struct points_in points = prepare(n, cells, seed);
    kit_given("%u points, all in one of %u cells", n, cells);
    for (uint32_t i = 0; i < n; i++)
        points.cell[i] = cells / 2;
    return points;
}

static void check(struct points_in points)
{
    CALL(STUDENT(histogram)(points.n, points.cell));
    for (uint32_t k = 0; k < cell_count; k++) {
        uint32_t right = tally(points, k).right;
        if (arrays[COUNTS][k] != right || notes->bad_lanes ||
            notes->bad_cell)
            WRONG(.where = kit_text("cell %u", k),
                  .expected = kit_text("%u points", right),
                  .found = kit_text("%u", arrays[COUNTS][k]),
                  .cause = cause(points, k));
    }
}

// The cycles of rounds of four calls; and of one such round, after
// which every loser makes so many calls of one lane.
struct bill {
    uint64_t rounds, most_rounds, losers;
    uint64_t cycles, first_rounds;
};

static struct bill add_up(struct points_in points)
{
    struct bill bill = {0};
    for (uint32_t i = 0; i < points.n; i += LANES) {
        uint32_t lanes = lanes_at(points.n, i), round = 0;
        bill.first_rounds += 4 * (STARTUP + lanes);
        for (uint32_t left = lanes; left > 0; round++) {
            bill.cycles += 4 * (STARTUP + left);
            left = 0;
            for (uint32_t k = 0; k < cell_count; k++) {
                uint32_t count = in_group(points, i, k);
                left += count > round + 1 ? count - round - 1 : 0;
            }
            bill.losers += round == 0 ? left : 0;
        }
        bill.rounds += round;
        if (round > bill.most_rounds)
            bill.most_rounds = round;
    }
    return bill;
}

static const char *cost_cause(struct points_in points, struct bill bill)
{
    for (int calls = 2; calls <= 4; calls++) {
        uint64_t one = (uint64_t)calls * (STARTUP + 1);
        if (notes->cycles == bill.first_rounds + bill.losers * one)
            return "The losers are counted one by one: let them form "
                   "a group.";
        if (notes->cycles == points.n * one)
            return "Every point is a group of its own: a call for one "
                   "lane takes nearly as long as one for many.";
    }
    if (notes->calls[SCRATCH] + notes->calls[COUNTS] > 4 * bill.rounds)
        return "There are more calls than four for each round, or "
               "more rounds: who has won does not play again, and a "
               "round needs no more than sign, look, read, store.";
    return "The calls are few enough, but have too many lanes: only "
           "those who have not yet won take part in the next round.";
}

static void check_cycles(struct points_in points)
{
    check(points);
    struct bill bill = add_up(points);
    if (notes->cycles > bill.cycles)
        WRONG(.expected = kit_text("at most %ju cycles, in %ju rounds",
                                   (uintmax_t)bill.cycles,
                                   (uintmax_t)bill.rounds),
              .found = kit_text("%ju cycles", (uintmax_t)notes->cycles),
              .cause = cost_cause(points, bill));
    kit_next_case();
}

static void apart(uint64_t seed)
{
    struct points_in points = prepare(LANES, 2 * LANES, seed);
    kit_given("%u points, each in a cell of its own", points.n);
    for (uint32_t i = 0; i < points.n; i++)
        points.cell[i] = 2 * i + 1;
    check(points);
}

static void right(uint64_t seed)
{
    check(scattered(1000, 500, seed));
    kit_next_case();
    check(scattered(1000, 20, seed));
}

static void few_points(uint64_t seed)
{
    static const uint32_t sizes[] = {0, 1, 2, LANES - 1, LANES + 1};
    for (int s = 0; s < 5; s++) {
        check(scattered(sizes[s], 10, seed + s));
        kit_next_case();
    }
    check(in_one_cell(3 * LANES + 5, 100, seed));
    kit_next_case();
    check(in_one_cell(LANES + 1, 1, seed));
}

static void cycles(uint64_t seed)
{
    check_cycles(scattered(2000, 1000, seed));
    check_cycles(scattered(2000, 100, seed));
}

static void cycles_one_cell(uint64_t seed)
{
    check_cycles(in_one_cell(5 * LANES, 100, seed));
}

const struct kit_test kit_tests[] = {
    {"apart", 1, "points that do not collide", apart},
    {"right", 1, "points that do", right},
    {"few-points", 1, "few points, and all in one cell", few_points},
    {"cycles", 6, "few cycles for points at random", cycles},
    {"cycles-one-cell", 1, "and in one cell", cycles_one_cell},
    {0},
};
