// Tests of cell order in place: the order, the starts, and the
// exchanges and looks against the number of strangers and of points.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"

// Of the student's process: the cells of the points in their slots, and
// what it did.
static uint32_t *cells;
static struct notes {
    uint64_t looks, exchanges;
    bool nowhere; // a slot that there is not
} * notes;
static uint32_t slots;
enum { LOOKS = 10, TOO_MANY = 100 }; // for each point

static bool is_endless(void)
{
    return notes->looks + notes->exchanges >
           (uint64_t)TOO_MANY * (slots + 100);
}

static void take_note_of(uint32_t slot)
{
    notes->nowhere = slot >= slots;
    if (notes->nowhere || is_endless())
        kit_leave();
}

uint32_t cell_of(uint32_t slot)
{
    notes->looks++;
    take_note_of(slot);
    return cells[slot];
}

void exchange(uint32_t s, uint32_t t)
{
    notes->exchanges++;
    take_note_of(s);
    take_note_of(t);
    uint32_t cell = cells[s];
    cells[s] = cells[t];
    cells[t] = cell;
}

// The case: what was there, and the right starts.
static uint32_t n, m;
static uint32_t *right_start;
static uint32_t strangers;

static void prepare(uint32_t points, uint32_t cell_count)
{
    n = slots = points;
    m = cell_count;
    cells = kit_output("the cells", n, sizeof *cells);
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.looks = 0};
}

static void find_right_starts(void)
{
    right_start = kit_input("the starts", m + 1, sizeof *right_start);
    for (uint32_t k = 0; k <= m; k++) {
        right_start[k] = 0;
        for (uint32_t s = 0; s < n; s++)
            right_start[k] += cells[s] < k;
    }
    strangers = 0;
    for (uint32_t k = 0; k < m; k++)
        for (uint32_t s = right_start[k]; s < right_start[k + 1]; s++)
            strangers += cells[s] != k;
}

static const char *start_cause(const uint32_t *start, uint32_t k)
{
    if (start[k] > n + m)
        return "Was this ever set? What the array held before is "
               "nonsense, also as a count to add to.";
    if (k < m && start[k] == right_start[k + 1])
        return "This is where the cell ends. The sum must not contain "
               "the cell's own points, and a program that advances the "
               "starts has to set them back.";
    if (k == m)
        return "The last start is where the last cell ends: n.";
    return "A cell begins after all the points of all the cells before "
           "it, and of no others.";
}

// m + 1 if all are right.
static uint32_t first_wrong(const uint32_t *start)
{
    uint32_t k = 0;
    while (k <= m && start[k] == right_start[k])
        k++;
    return k;
}

static void check_starts(const uint32_t *start)
{
    uint32_t k = first_wrong(start);
    if (k <= m)
        WRONG(.where = kit_text("start[%u]", k),
              .expected = kit_text("%u", right_start[k]),
              .found = kit_text("%u", start[k]),
              .cause = start_cause(start, k));
}

static void check_order(void)
{
    for (uint32_t k = 0; k < m; k++)
        for (uint32_t s = right_start[k]; s < right_start[k + 1]; s++)
            if (cells[s] != k)
                WRONG(.where = kit_text("slot %u", s),
                      .expected = kit_text("a point of cell %u", k),
                      .found = kit_text("one of cell %u", cells[s]),
                      .cause =
                          notes->exchanges == 0
                              ? "No point was moved."
                              : "When one has gone home, another "
                                "stands in its slot, and may be a "
                                "stranger, too: look again, before you "
                                "go on to the next slot.");
}

static const char *nowhere_cause(const uint32_t *start)
{
    uint32_t k = first_wrong(start);
    if (k <= m)
        return kit_text("start[%u] was %u then, not %u. %s", k,
                        start[k], right_start[k],
                        start_cause(start, k));
    return "A search for a stranger ran past the last slot. If a point "
           "is a stranger, there is another in its own cell, but only "
           "among that cell's slots.";
}

static void check_calls(const uint32_t *start)
{
    if (notes->nowhere)
        WRONG(.expected = kit_text("slots below %u", n),
              .found = "a slot that there is not",
              .cause = nowhere_cause(start));
    if (is_endless())
        WRONG(.expected = "an end",
              .found = kit_text("more than %d calls for each point",
                                TOO_MANY),
              .cause = "This does not come to an end, or takes a time "
                       "that grows with the square of n. Does every "
                       "exchange bring a point home, and does the "
                       "search for the next stranger begin where the "
                       "last one was found?");
}

static void check(void)
{
    find_right_starts();
    uint32_t *start = kit_output("start", m + 1, sizeof *start);
    CALL(STUDENT(back_in_order)(n, m, start));
    check_calls(start);
    check_starts(start);
    check_order();
}

static void check_exchanges(void)
{
    check();
    if (notes->exchanges > strangers)
        WRONG(.expected =
                  kit_text("at most %u exchanges, one for every "
                           "stranger",
                           strangers),
              .found = kit_text("%ju", (uintmax_t)notes->exchanges),
              .cause =
                  strangers == 0
                      ? "All points were at home already. Look before "
                        "you exchange."
                      : "Points that were at home were sent away. "
                        "Before you put one into the next slot of its "
                        "cell, look whether the one that is there is "
                        "at home, and pass by.");
}

static void check_looks(void)
{
    check();
    if (notes->looks > (uint64_t)LOOKS * n)
        WRONG(.expected = kit_text("at most %d calls of cell_of for "
                                   "each of %u points",
                                   LOOKS, n),
              .found = kit_text("%.1f", (double)notes->looks / n),
              .cause = "Does the search for the next stranger in a "
                       "cell begin at its first slot every time? Begin "
                       "where the last one was found.");
}

// ---- where the points are ------------------------------------------

static void scatter(uint32_t points, uint32_t cell_count, uint64_t seed)
{
    struct random random = {seed};
    prepare(points, cell_count);
    for (uint32_t s = 0; s < n; s++)
        cells[s] = random_bits(&random) % m;
    kit_given("%u points in %u cells, in no order", n, m);
}

// In order, two in every cell; then some move to the next cell or row.
static void stray(uint32_t cell_count, uint32_t one_in, uint64_t seed)
{
    struct random random = {seed};
    prepare(2 * cell_count, cell_count);
    for (uint32_t s = 0; s < n; s++) {
        cells[s] = s / 2;
        const uint32_t steps[] = {1, m - 1, 10, m - 10};
        if (one_in > 0 && random_bits(&random) % one_in == 0)
            cells[s] = (cells[s] + steps[random_bits(&random) % 4]) % m;
    }
    if (one_in == 0)
        kit_given("%u points in %u cells, all at home", n, m);
    else
        kit_given("%u points in %u cells, one in %u has moved to "
                  "another",
                  n, m, one_in);
}

static void right(uint64_t seed)
{
    scatter(1000, 100, seed);
    check();
    kit_next_case();
    stray(300, 10, seed);
    check();
}

static void odd_sets(uint64_t seed)
{
    scatter(0, 3, seed);
    check();
    kit_next_case();
    scatter(1, 5, seed);
    check();
    kit_next_case();
    scatter(20, 1, seed);
    check();
    kit_next_case();
    scatter(5, 100, seed);
    check();
    kit_next_case();
    prepare(30, 10);
    for (uint32_t s = 0; s < n; s++)
        cells[s] = 7;
    kit_given("30 points, all in cell 7 of 10");
    check();
    kit_next_case();
    prepare(40, 20);
    for (uint32_t s = 0; s < n; s++)
        cells[s] = 19 - s / 2;
    kit_given("40 points in 20 cells, the last cell first");
    check();
}

static void at_home(uint64_t seed)
{
    stray(100, 0, seed);
    check_exchanges();
}

static void strayed(uint64_t seed)
{
    for (uint32_t trial = 0; trial < 20; trial++) {
        stray(200, 15, seed + trial);
        check_exchanges();
        kit_next_case();
    }
}

static void scattered(uint64_t seed)
{
    for (uint32_t trial = 0; trial < 20; trial++) {
        scatter(400, 50, seed + trial);
        check_exchanges();
        kit_next_case();
    }
}

static void large(uint64_t seed)
{
    scatter(100000, 200, seed);
    check_looks();
    kit_next_case();
    stray(10000, 20, seed);
    check_looks();
}

const struct kit_test kit_tests[] = {
    {"right", 1, "the order and the starts", right},
    {"odd-sets", 1, "empty cells, one cell, no points", odd_sets},
    {"at-home", 1, "no exchange where all are at home", at_home},
    {"strayed", 3, "few exchanges, points that strayed", strayed},
    {"scattered", 2, "few exchanges, no order at all", scattered},
    {"large", 2, "100,000 points, looks at each", large},
    {0},
};
