// Tests of the sort without collisions: order, collisions, and calls of
// the vector unit, for points at random, in few cells and in one.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static const uint32_t unset = 0xa5a5a5a5; // in a new output

// The vector unit, in the student's process, which ends with the first
// call that cannot be obeyed.
static uint32_t *arrays[2], sizes[2];
static struct notes {
    uint64_t calls, scans;
    enum { NOTHING, BAD_LANES, BAD_PLACE, COLLISION } fault;
    enum array array;
    uint32_t lanes, lane, other, place; // of the fault
} * notes;

static const char *const names[] = {"COUNTS", "PLACES"};

static bool valid(enum array array, uint32_t lanes, const uint32_t *at)
{
    if (notes->fault != NOTHING)
        return false;
    notes->array = array;
    notes->lanes = lanes;
    if (lanes < 1 || lanes > LANES) {
        notes->fault = BAD_LANES;
        return false;
    }
    for (uint32_t l = 0; l < lanes; l++) {
        notes->lane = l;
        notes->place = at[l];
        if (at[l] >= sizes[array])
            notes->fault = BAD_PLACE;
        for (uint32_t k = 0; k < l; k++)
            if (at[k] == at[l]) {
                notes->fault = COLLISION;
                notes->other = k;
            }
        if (notes->fault != NOTHING)
            return false;
    }
    notes->calls++;
    return true;
}

void gather(enum array array, uint32_t lanes, const uint32_t *at,
            uint32_t *to)
{
    if (!valid(array, lanes, at))
        return;
    for (uint32_t l = 0; l < lanes; l++)
        to[l] = arrays[array][at[l]];
}

void scatter(enum array array, uint32_t lanes, const uint32_t *at,
             const uint32_t *from)
{
    if (!valid(array, lanes, at))
        return;
    for (uint32_t l = 0; l < lanes; l++)
        arrays[array][at[l]] = from[l];
}

void scan_counts(void)
{
    uint32_t sum = 0;
    notes->scans++;
    for (uint32_t c = 0; c < sizes[COUNTS]; c++) {
        uint32_t here = arrays[COUNTS][c];
        arrays[COUNTS][c] = sum;
        sum += here;
    }
}

struct input {
    uint32_t n, cells, *cell;
};

static struct input prepare(uint32_t n, uint32_t cells, uint64_t seed)
{
    kit_given("%u points, %u cells", n, cells);
    sizes[COUNTS] = cells * LANES;
    sizes[PLACES] = n;
    for (int a = 0; a < 2; a++)
        arrays[a] = kit_output(names[a], sizes[a], sizeof(uint32_t));
    memset(arrays[COUNTS], 0, sizes[COUNTS] * sizeof(uint32_t));
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){0};
    struct input input = {n, cells,
                          kit_input("cell", n, sizeof(uint32_t))};
    struct random random = {seed};
    for (uint32_t i = 0; i < n; i++)
        input.cell[i] = random_bits(&random) % cells;
    return input;
}

// The points by cell; inside a cell by the lane that has them, of
// so many, if they are dealt out like cards, then by number.
static uint32_t *sorted(struct input input, uint32_t dealt)
{
    uint32_t *point = kit_input("sorted", input.n, sizeof *point);
    uint32_t to = 0;
    for (uint32_t k = 0; k < input.cells; k++)
        for (uint32_t lane = 0; lane < dealt; lane++)
            for (uint32_t i = lane; i < input.n; i += dealt)
                if (input.cell[i] == k)
                    point[to++] = i;
    return point;
}

static bool in_order_of_cells(struct input input, const uint32_t *point)
{
    for (uint32_t s = 1; s < input.n; s++)
        if (input.cell[point[s - 1]] > input.cell[point[s]])
            return false;
    return true;
}

static bool all_unset(const uint32_t *point, uint32_t n)
{
    uint32_t s = 0;
    while (s < n && point[s] == unset)
        s++;
    return s == n;
}

// The first point that is not there, or n.
static uint32_t missing(struct input input, const uint32_t *point)
{
    bool *there = kit_input("who is there", input.n, sizeof *there);
    memset(there, false, input.n);
    for (uint32_t s = 0; s < input.n; s++)
        if (point[s] < input.n)
            there[point[s]] = true;
    uint32_t i = 0;
    while (i < input.n && there[i])
        i++;
    return i;
}

static const char *scan_cause(void)
{
    return kit_text("scan_counts() was called %ju times. Once, between "
                    "counting and placing, makes counts into places.",
                    (uintmax_t)notes->scans);
}

static const char *order_cause(struct input input)
{
    const uint32_t *found = arrays[PLACES];
    uint32_t lost = missing(input, found);
    if (notes->scans != 1)
        return scan_cause();
    if (all_unset(found, input.n))
        return "No point was placed.";
    if (lost < input.n && lost >= input.n / LANES * LANES)
        return kit_text("Point %u has no lane: is n / LANES rounded "
                        "down?",
                        lost);
    if (lost < input.n)
        return kit_text("Point %u stands nowhere, or was overwritten. "
                        "Does the next place of its cell and lane move "
                        "on when one is taken?",
                        lost);
    if (!in_order_of_cells(input, found))
        return "The points are not together by cells. The scan adds "
               "the counts in the order of their places: all lanes of "
               "one cell, side by side, come before the next cell.";
    if (memcmp(found, sorted(input, LANES), input.n * sizeof *found) ==
        0)
        return "The points were dealt to the lanes like cards. The "
               "scan puts lane 0 before lane 1, so the points of lane "
               "0 must come before those of lane 1.";
    return "The cells are right, but not the order inside: the points "
           "of a lane come one after the other, and lanes in the order "
           "of their points.";
}

static void refuse(void)
{
    const char *name = names[notes->array];
    bool placing = notes->array == PLACES;
    switch (notes->fault) {
    case BAD_LANES:
        WRONG(.expected = kit_text("1 to %u lanes", (uint32_t)LANES),
              .found = kit_text("%u", notes->lanes),
              .cause = "Lanes without a point take no part, and a call "
                       "without lanes need not be made.");
    case BAD_PLACE:
        WRONG(.where = kit_text("lane %u", notes->lane),
              .expected = kit_text("a place below %u in %s",
                                   sizes[notes->array], name),
              .found = kit_text("%u", notes->place),
              .cause = placing && notes->scans != 1 ? scan_cause()
                       : placing
                           ? "There are only n places. Does counting "
                             "count each point once?"
                           : "There are LANES counts for every cell, "
                             "and no more.");
    case COLLISION:
        WRONG(.where = kit_text("lanes %u and %u", notes->other,
                                notes->lane),
              .expected = "different places",
              .found = kit_text("both at place %u of %s", notes->place,
                                name),
              .cause = placing && notes->scans != 1 ? scan_cause()
                       : placing
                           ? "Two points got the same place: does each "
                             "lane count and place the same points?"
                           : "Two lanes share a count. Each needs one "
                             "of its own for every cell.");
    default:
        break;
    }
}

static void check(struct input input)
{
    CALL(STUDENT(sort_by_cell)(input.n, input.cell));
    refuse();
    const uint32_t *right = sorted(input, 1);
    for (uint32_t s = 0; s < input.n; s++) {
        uint32_t found = arrays[PLACES][s];
        if (found != right[s])
            WRONG(.where = kit_text("place %u, in cell %u", s,
                                    input.cell[right[s]]),
                  .expected = kit_text("point %u", right[s]),
                  .found = found == unset ? "never set"
                                          : kit_text("point %u", found),
                  .cause = order_cause(input));
    }
}

static void check_calls(struct input input)
{
    check(input);
    uint32_t n = input.n, steps = (n + LANES - 1) / LANES;
    uint64_t calls = notes->calls;
    uint64_t rest = n / LANES + n % LANES;
    if (calls > 5 * steps)
        WRONG(.expected = kit_text("at most %u calls", 5 * steps),
              .found = kit_text("%ju", (uintmax_t)calls),
              .cause = calls >= 5 * (uint64_t)n
                           ? "Only one lane works at a time."
                       : calls == 5 * rest
                           ? "The last points are taken one by one: "
                             "let the blocks be n / LANES, rounded up."
                           : "A step reads and stores the counts, then "
                             "reads, places and stores. Is anything "
                             "read twice?");
    kit_next_case();
}

static struct input in_one_cell(uint32_t n, uint32_t cells)
{
    struct input input = prepare(n, cells, 0);
    kit_given("%u points, all in one of %u cells", n, cells);
    for (uint32_t i = 0; i < n; i++)
        input.cell[i] = cells - 1;
    return input;
}

static void right(uint64_t seed)
{
    check(prepare(40 * LANES, 100, seed));
    kit_next_case();
    check(prepare(1000, 3, seed));
}

static void one_cell(uint64_t seed)
{
    (void)seed;
    check(in_one_cell(20 * LANES, 7));
    kit_next_case();
    check(in_one_cell(333, 1));
}

static void uneven(uint64_t seed)
{
    for (uint32_t n = 6 * LANES; n <= 8 * LANES; n++) {
        check(prepare(n, 10, seed + n));
        kit_next_case();
    }
}

static void few_points(uint64_t seed)
{
    for (uint32_t n = 0; n <= 2 * LANES; n++) {
        check(prepare(n, 4, seed + n));
        kit_next_case();
    }
}

static void calls(uint64_t seed)
{
    check_calls(prepare(40 * LANES, 100, seed));
    check_calls(in_one_cell(40 * LANES, 100));
}

static void calls_uneven(uint64_t seed)
{
    check_calls(prepare(40 * LANES - 5, 100, seed));
    check_calls(prepare(LANES + 1, 4, seed));
}

const struct kit_test kit_tests[] = {
    {"right", 1, "points in many cells, and in three", right},
    {"one-cell", 1, "all points in one cell", one_cell},
    {"uneven", 1, "lanes without a point at the end", uneven},
    {"few-points", 1, "from no point to two for a lane", few_points},
    {"calls", 4, "few calls, whatever the points are", calls},
    {"calls-uneven", 2, "and if lanes run out of points", calls_uneven},
    {0},
};
