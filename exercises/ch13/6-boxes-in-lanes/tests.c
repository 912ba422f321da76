// Tests of the boxes that meet one: their numbers, and the time, beside
// that of comparing axis after axis.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>

enum { ROUNDS = 4000, QUERIES = 64, ASKED = 8 };

static struct boxes boxes;
static struct box *query;
static uint32_t *found, *found_by[ASKED], *count;

// Boxes up to so large, in a unit cube; with steps, all places are
// multiples of 1/steps.
static void prepare(uint32_t n, double size, double steps,
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    double *side[2][3];
    for (int s = 0; s < 2; s++)
        for (int k = 0; k < 3; k++)
            side[s][k] =
                kit_input(s ? "high" : "low", n, sizeof(double));
    query = kit_input("the box", QUERIES, sizeof *query);
    for (int q = 0; q < ASKED; q++)
        found_by[q] = kit_output("found", n, sizeof *found);
    found = found_by[0];
    count = kit_output("the answer", ASKED, sizeof *count);
    for (uint32_t i = 0; i < n + QUERIES; i++)
        for (int k = 0; k < 3; k++) {
            const double x = random_uniform(&random);
            const double y = x + size * random_uniform(&random);
            const double low = floor(x * steps) / steps;
            const double high = floor(y * steps) / steps;
            if (i < n) {
                side[0][k][i] = low;
                side[1][k][i] = high;
            } else {
                query[i - n].low[k] = low;
                query[i - n].high[k] = high;
            }
        }
    boxes.n = n;
    for (int k = 0; k < 3; k++) {
        boxes.low[k] = side[0][k];
        boxes.high[k] = side[1][k];
    }
    kit_given("%u boxes", n);
}

// ---- answers -------------------------------------------------------

// How they meet along an axis: 0 if not, 1 if they only touch.
static int how(uint32_t i, const struct box *b, int k)
{
    const double one = b->high[k] - boxes.low[k][i];
    const double other = boxes.high[k][i] - b->low[k];
    return one < 0 || other < 0 ? 0 : one == 0 || other == 0 ? 1 : 2;
}

static bool is_met(uint32_t i, const struct box *b)
{
    return how(i, b, 0) && how(i, b, 1) && how(i, b, 2);
}

static const char *cause_of(uint32_t i, const struct box *b)
{
    if (i >= boxes.n)
        return "There is no such box, or none is left.";
    if (!is_met(i, b))
        return "This one does not meet the box along all three axes.";
    if (how(i, b, 0) == 1 || how(i, b, 1) == 1 || how(i, b, 2) == 1)
        return "To touch is to meet.";
    if (i >= boxes.n / 8 * 8)
        return "Are the last boxes looked at, where a strip is not "
               "full?";
    return "A box that meets is missing, or stands at another place.";
}

static void check(const struct box *b, const uint32_t *found,
                  uint32_t count)
{
    uint32_t right = 0;
    for (uint32_t i = 0; i < boxes.n; i++)
        right += is_met(i, b);
    uint32_t k = 0;
    for (uint32_t i = 0; i < boxes.n; i++) {
        if (!is_met(i, b))
            continue;
        if (k >= count || found[k] != i)
            WRONG(.where = kit_text("place %u of found", k),
                  .expected = kit_text("box %u", i),
                  .found = k >= count ? "nothing"
                                      : kit_text("box %u", found[k]),
                  .cause = cause_of(
                      k >= count || found[k] > i ? i : found[k], b));
        k++;
    }
    if (count != right)
        WRONG(.expected = kit_text("%u boxes", right),
              .found = kit_text("%u", count),
              .cause = right < boxes.n && found[right] < boxes.n &&
                               !is_met(found[right], b)
                           ? cause_of(found[right], b)
                           : "More are counted than meet.");
}

static void check_all(uint64_t seed, double size, double steps)
{
    for (uint32_t n = 0; n < 400; n += 1 + n / 4) {
        prepare(n, size, steps, seed + n);
        CALL(for (int q = 0; q < ASKED; q++) {
            count[q] =
                STUDENT(find_meeting)(boxes, &query[q], found_by[q]);
            check(&query[q], found_by[q], count[q]);
        });
        for (int q = 0; q < ASKED; q++)
            check(&query[q], found_by[q], count[q]);
    }
}

static void any(uint64_t seed)
{
    check_all(seed, 0.4, 0x1p40);
}

static void touching(uint64_t seed)
{
    check_all(seed, 0.5, 6);
}

// ---- time ----------------------------------------------------------

static void theirs(void)
{
    CALL(for (int r = 0; r < ROUNDS; r++) *count =
             STUDENT(find_meeting)(boxes, &query[r % QUERIES], found));
}

static uint32_t axis_after_axis(const struct box *b)
{
    uint32_t met = 0;
    for (uint32_t i = 0; i < boxes.n; i++) {
        if (boxes.low[0][i] > b->high[0] ||
            boxes.high[0][i] < b->low[0])
            continue;
        if (boxes.low[1][i] > b->high[1] ||
            boxes.high[1][i] < b->low[1])
            continue;
        if (boxes.low[2][i] > b->high[2] ||
            boxes.high[2][i] < b->low[2])
            continue;
        found[met++] = i;
    }
    return met;
}

static void obvious(void)
{
    CALL(for (int r = 0; r < ROUNDS; r++) *count =
             axis_after_axis(&query[r % QUERIES]));
}

static void in_time(uint64_t seed)
{
    any(seed);
    prepare(1000, 0.6, 0x1p40, seed);
    const double ratio =
        kit_race((struct kit_race){theirs, obvious, .cores = 1});
    kit_bands(
        ratio,
        (struct kit_band[]){{0.5, 6}, {0.67, 4}, {0.83, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "half of the time of comparing axis after axis",
            .found = kit_text("%.2f of it", ratio),
            .cause = "A branch that goes either way is guessed wrong "
                     "again and again: compute truths instead."});
}

const struct kit_test kit_tests[] = {
    {"any", 2, "the boxes that meet, lowest first", any},
    {"touching", 2, "boxes that touch", touching},
    {"time", 6, "twice as fast as axis after axis", in_time},
    {0},
};
