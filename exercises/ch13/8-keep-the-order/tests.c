// Tests of the order that is kept: steps are made one after the other,
// and what was reported is played again afterward. Then the order and
// the table of meetings are compared with all pairs of ends.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BOXES = 500, STEPS = 8, MOST_REPORTS = 200000 };

struct report {
    uint32_t i, j;
    bool begins;
};

struct counts {
    uint64_t asked, swapped;
    uint32_t reports; // so far
};

static uint32_t n, ends, step;
static double (*at)[2];     // at[step * n + box]: low and high
static struct end *first;   // the order at the beginning
static struct end *list;    // list[step * ends + place]
static struct end *current; // that of this step
static struct report *report;
static struct counts *counts; // of each step
static bool meets[MOST_BOXES][MOST_BOXES];

// ---- what is given -------------------------------------------------

// Whether end a comes before end b in a step.
static bool is_before(uint32_t in_step, struct end a, struct end b)
{
    const double x = at[in_step * n + a.box][a.high];
    const double y = at[in_step * n + b.box][b.high];
    if (x != y)
        return x < y;
    return a.high != b.high ? b.high : a.box < b.box;
}

struct end end_at(uint32_t place)
{
    if (place >= ends)
        abort();
    return current[place];
}

bool in_order(uint32_t place)
{
    counts[step].asked++;
    const struct end a = end_at(place), b = end_at(place + 1);
    return is_before(step, a, b);
}

void swap_ends(uint32_t place)
{
    counts[step].swapped++;
    const struct end a = end_at(place), b = end_at(place + 1);
    current[place] = b;
    current[place + 1] = a;
}

static void put(struct report made)
{
    if (counts[step].reports < MOST_REPORTS)
        report[counts[step].reports++] = made;
}

void meeting_begins(uint32_t i, uint32_t j)
{
    put((struct report){i, j, true});
}

void meeting_ends(uint32_t i, uint32_t j)
{
    put((struct report){i, j, false});
}

// ---- the scenes ----------------------------------------------------

static int compare(const void *one, const void *other)
{
    const struct end *a = one, *b = other;
    return is_before(0, *b, *a) - is_before(0, *a, *b);
}

// Boxes begin in 0 to 1. In each step they move by up to the motion,
// and one of them, if it jumps, to anywhere. With steps, all places are
// multiples of 1/fine.
static void prepare(uint32_t boxes, double motion, bool jumps,
                    double fine, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = boxes;
    ends = 2 * n;
    at = kit_input("the places", (STEPS + 1) * n, sizeof *at);
    first = kit_input("the first order", ends, sizeof *first);
    list = kit_output("the orders", (STEPS + 1) * ends, sizeof *list);
    report = kit_output("the reports", MOST_REPORTS, sizeof *report);
    counts = kit_output("the counts", STEPS + 1, sizeof *counts);
    for (uint32_t i = 0; i < n; i++) {
        double low = random_uniform(&random);
        const double size = 10.0 / n * random_uniform(&random);
        for (uint32_t s = 0; s <= STEPS; s++) {
            if (jumps && s % n == i)
                low = random_uniform(&random);
            low += motion * (2 * random_uniform(&random) - 1);
            at[s * n + i][0] = floor(low * fine) / fine;
            at[s * n + i][1] = floor((low + size) * fine) / fine;
        }
        first[2 * i] = (struct end){i, false};
        first[2 * i + 1] = (struct end){i, true};
    }
    qsort(first, ends, sizeof *first, compare);
    kit_given("%u boxes", n);
}

// ---- what is right -------------------------------------------------

static bool meet(uint32_t s, uint32_t i, uint32_t j)
{
    return at[s * n + i][0] <= at[s * n + j][1] &&
           at[s * n + j][0] <= at[s * n + i][1];
}

static const char *text_of(struct end end)
{
    return kit_text("the %s end of box %u", end.high ? "high" : "low",
                    end.box);
}

static void check_order(uint32_t s)
{
    const struct end *order = list + s * ends;
    for (uint32_t p = 0; p + 1 < ends; p++)
        if (order[p].box >= n || order[p + 1].box >= n ||
            !is_before(s, order[p], order[p + 1]))
            WRONG(.where = kit_text("step %u, places %u and %u", s, p,
                                    p + 1),
                  .expected = "the lower end first",
                  .found = kit_text("%s before %s", text_of(order[p]),
                                    text_of(order[p + 1])),
                  .cause = "An end may have to pass many others: carry "
                           "it on until it is in order.");
}

static void play(uint32_t s)
{
    for (uint32_t r = counts[s - 1].reports; r < counts[s].reports;
         r++) {
        const struct report *made = &report[r];
        const uint32_t i = made->i, j = made->j;
        if (i >= n || j >= n || i == j)
            WRONG(.where = kit_text("step %u", s),
                  .expected = "a report of two boxes",
                  .found = kit_text("boxes %u and %u", i, j));
        if (meets[i][j] == made->begins)
            WRONG(.where =
                      kit_text("step %u, boxes %u and %u", s, i, j),
                  .expected = "no such report",
                  .found = made->begins ? "that they begin to meet"
                                        : "that they cease to meet",
                  .cause = made->begins
                               ? "They met already. Which two kinds of "
                                 "ends must pass each other, and in "
                                 "which direction?"
                               : "They did not meet. Which two kinds "
                                 "of ends must pass each other, and "
                                 "in which direction?");
        meets[i][j] = meets[j][i] = made->begins;
    }
}

static void check_meetings(uint32_t s)
{
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < i; j++)
            if (meets[i][j] != meet(s, i, j))
                WRONG(.where =
                          kit_text("step %u, boxes %u and %u", s, j, i),
                      .expected = meets[i][j] ? "they no longer meet"
                                              : "they begin to meet",
                      .found = "no report of that",
                      .cause = meets[i][j]
                                   ? "Where a high end passes a low "
                                     "one to the left, a meeting ends."
                                   : "Where a low end passes a high "
                                     "one to the left, a meeting "
                                     "begins.");
}

static void run_steps(void)
{
    CALL(memset(counts, 0, (STEPS + 1) * sizeof *counts);
         memcpy(list, first, ends * sizeof *list);
         for (step = 1; step <= STEPS; step++) {
             current = list + step * ends;
             memcpy(current, current - ends, ends * sizeof *list);
             counts[step].reports = counts[step - 1].reports;
             STUDENT(repair)(ends);
         });
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = 0; j < n; j++)
            meets[i][j] = meet(0, i, j);
    for (uint32_t s = 1; s <= STEPS; s++) {
        check_order(s);
        play(s);
        check_meetings(s);
    }
}

// How many pairs of ends must pass each other in all steps.
static double passes(void)
{
    double count = 0;
    for (uint32_t s = 1; s <= STEPS; s++) {
        const struct end *before = list + (s - 1) * ends;
        for (uint32_t p = 0; p < ends; p++)
            for (uint32_t q = p + 1; q < ends; q++)
                count += is_before(s, before[q], before[p]);
    }
    return count;
}

// ---- the tests -----------------------------------------------------

static void small(uint64_t seed)
{
    for (uint32_t boxes = 1; boxes < 200; boxes = 2 * boxes + 1) {
        prepare(boxes, 1.0 / boxes, false, 0x1p40, seed + boxes);
        run_steps();
    }
}

static void jumps(uint64_t seed)
{
    for (uint32_t boxes = 2; boxes < 200; boxes = 2 * boxes + 1) {
        prepare(boxes, 0, true, 0x1p40, seed + boxes);
        run_steps();
    }
}

static void equal(uint64_t seed)
{
    for (uint32_t boxes = 2; boxes < 200; boxes = 2 * boxes + 1) {
        prepare(boxes, 2.0 / boxes, boxes % 2, boxes, seed + boxes);
        run_steps();
    }
}

static void count(uint64_t seed)
{
    double worst = 0;
    for (int part = 0; part < 3; part++) {
        prepare(MOST_BOXES, part == 0 ? 0 : 0.1 / MOST_BOXES, part == 2,
                0x1p40, seed + part);
        run_steps();
        double done = 0;
        for (uint32_t s = 1; s <= STEPS; s++)
            done += (double)(counts[s].asked + counts[s].swapped);
        worst = fmax(worst, done / (STEPS * ends + 2 * passes()));
    }
    kit_bands(
        worst, (struct kit_band[]){{1.6, 6}, {4, 3}, {0, 0}},
        (struct kit_fault){
            .expected = "questions and swaps in proportion to the "
                        "motion",
            .found = kit_text("%.1f times e + 2 v", worst),
            .cause = "What is in order already need not be looked "
                     "at again."});
}

const struct kit_test kit_tests[] = {
    {"small", 2, "small motions", small},
    {"jumps", 1, "a box that jumps", jumps},
    {"equal", 1, "ends that are equal", equal},
    {"count", 6, "work in proportion to the motion", count},
    {0},
};
