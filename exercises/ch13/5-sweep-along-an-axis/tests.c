// Tests of the sweep: the pairs, against all pairs, and how many
// questions were asked.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

struct box {
    double low[3], high[3];
};

static uint32_t n, *order, *found;
static struct box *box;
static struct pair *pair;
static uint64_t *asked;

int compare_begins(uint32_t i, uint32_t j)
{
    ++*asked;
    return (box[i].low[0] > box[j].low[0]) -
           (box[i].low[0] < box[j].low[0]);
}

bool begins_within(uint32_t i, uint32_t j)
{
    ++*asked;
    return box[j].low[0] <= box[i].high[0];
}

static bool meet_along(uint32_t i, uint32_t j, int k)
{
    return box[i].low[k] <= box[j].high[k] &&
           box[j].low[k] <= box[i].high[k];
}

bool meet_across(uint32_t i, uint32_t j)
{
    ++*asked;
    return meet_along(i, j, 1) && meet_along(i, j, 2);
}

// Boxes up to so wide along x, up to 1/2 across. With steps, all places
// are multiples of 1/steps, so that many touch or begin together.
static void prepare(uint32_t count, double wide, double steps,
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = count;
    box = kit_input("the boxes", n, sizeof *box);
    order = kit_output("order", n, sizeof *order);
    pair = kit_output("pair", 1 + (size_t)n * n / 2, sizeof *pair);
    found = kit_output("the answer", 1, sizeof *found);
    asked = kit_output("the count", 1, sizeof *asked);
    for (uint32_t i = 0; i < n; i++)
        for (int k = 0; k < 3; k++) {
            const double size =
                (k == 0 ? wide : 0.5) * random_uniform(&random);
            double low = random_uniform(&random), high = low + size;
            if (steps > 0) {
                low = floor(steps * low) / steps;
                high = floor(steps * high) / steps;
            }
            box[i].low[k] = low;
            box[i].high[k] = high;
        }
    kit_given("%u boxes", n);
}

static bool meet(uint32_t i, uint32_t j)
{
    return meet_along(i, j, 0) && meet_along(i, j, 1) &&
           meet_along(i, j, 2);
}

static uint64_t key_of(const void *p)
{
    const struct pair *at = p;
    return (uint64_t)at->one << 32 | at->other;
}

static int compare(const void *one, const void *other)
{
    return (key_of(one) > key_of(other)) -
           (key_of(one) < key_of(other));
}

static const char *why_missing(uint32_t i, uint32_t j)
{
    if (box[i].low[0] == box[j].low[0])
        return "Boxes that begin at the same place meet along x.";
    if (box[i].low[0] == box[j].high[0] ||
        box[j].low[0] == box[i].high[0])
        return "To touch is to meet.";
    return "The walk ends at the first box that begins too late, and "
           "at no other; it begins at every box.";
}

// Puts the lower number first, sorts, and looks for wrong ones.
static void normalize(struct pair *sorted, uint32_t count)
{
    for (uint32_t k = 0; k < count; k++) {
        const uint32_t a = sorted[k].one, b = sorted[k].other;
        if (a >= n || b >= n || a == b)
            WRONG(.expected = "pairs of two boxes",
                  .found = kit_text("boxes %u and %u", a, b));
        if (!meet(a, b))
            WRONG(.where = kit_text("boxes %u and %u", a, b),
                  .expected = "no pair", .found = "a pair",
                  .cause = meet_along(a, b, 0)
                               ? "They do not meet along the other "
                                 "axes."
                               : "They do not meet along x.");
        sorted[k] = a < b ? sorted[k] : (struct pair){b, a};
    }
    qsort(sorted, count, sizeof *sorted, compare);
    for (uint32_t k = 1; k < count; k++)
        if (key_of(&sorted[k]) == key_of(&sorted[k - 1]))
            WRONG(.where = kit_text("boxes %u and %u", sorted[k].one,
                                    sorted[k].other),
                  .expected = "once", .found = "more than once",
                  .cause = "Look only at boxes that follow in the "
                           "order.");
}

static uint64_t ask(void)
{
    CALL(*asked = 0; *found = STUDENT(find_pairs)(n, order, pair));
    if (*found > n * (n - (n > 0)) / 2)
        WRONG(.expected = "at most all pairs",
              .found = kit_text("%u", *found));
    normalize(pair, *found);
    uint64_t along = 0;
    uint32_t k = 0;
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            along += meet_along(i, j, 0);
            const bool is_there =
                k < *found && pair[k].one == i && pair[k].other == j;
            if (meet(i, j) && !is_there)
                WRONG(.where = kit_text("boxes %u and %u", i, j),
                      .expected = "a pair", .found = "no pair",
                      .cause = why_missing(i, j));
            k += is_there;
        }
    return along;
}

static void right(uint64_t seed)
{
    for (uint32_t count = 0; count < 200; count = count * 3 / 2 + 1) {
        prepare(count, 0.3, 0, seed + count);
        ask();
    }
}

static void touching(uint64_t seed)
{
    for (uint32_t count = 2; count < 200; count = count * 3 / 2 + 1) {
        prepare(count, 0.5, 8, seed + count);
        ask();
    }
}

static void questions(uint64_t seed)
{
    double worst = 0;
    for (uint32_t count = 500; count <= 2000; count *= 2) {
        prepare(count, 20.0 / count, 0, seed + count);
        const double along = (double)ask();
        const double most = 2 * n * log2(n) + 2 * (n + along);
        worst = fmax(worst, (double)*asked / most);
    }
    kit_bands(worst, (struct kit_band[]){{1, 6}, {3, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 2 n log n + 2 (n + m) questions",
                  .found = kit_text("%.2f times as many", worst),
                  .cause =
                      "In the right order, a box need look only at "
                      "few others. How many questions does your "
                      "sort ask?"});
}

const struct kit_test kit_tests[] = {
    {"right", 2, "all pairs of boxes that meet", right},
    {"touching", 2, "boxes that touch or begin together", touching},
    {"questions", 6, "far fewer questions than for all pairs",
     questions},
    {0},
};
