// Tests of unpack: answers, against a copy that is not in place and
// against what students write instead, and how often a value is moved.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

enum { MOST = 5000 };
static const double hole = -1;

// ---- the array -----------------------------------------------------

static uint32_t places;
static double *values;
static struct notes {
    uint64_t moves, clears;
    bool outside;
    uint32_t place;
} * notes;

static void need(uint32_t place)
{
    if (place < places)
        return;
    notes->outside = true;
    notes->place = place;
    kit_leave();
}

void move(uint32_t from, uint32_t to)
{
    need(from);
    need(to);
    notes->moves++;
    values[to] = values[from];
}

void clear(uint32_t place)
{
    need(place);
    notes->clears++;
    values[place] = hole;
}

// ---- mistakes ------------------------------------------------------

static uint32_t count(uint32_t n, const uint8_t *keep)
{
    uint32_t survivors = 0;
    for (uint32_t i = 0; i < n; i++)
        survivors += keep[i];
    return survivors;
}

// The mistakes that are known, each done to a copy of the array.
static void unpack_right(uint32_t n, const uint8_t *keep,
                         const double *packed, double *result)
{
    uint32_t next = 0;
    for (uint32_t i = 0; i < n; i++)
        result[i] = keep[i] ? packed[next++] : hole;
}

static void from_the_front(uint32_t n, const uint8_t *keep,
                           const double *packed, double *result)
{
    memcpy(result, packed, n * sizeof *result);
    uint32_t next = 0;
    for (uint32_t i = 0; i < n; i++)
        result[i] = keep[i] ? result[next++] : hole;
}

static void no_holes(uint32_t n, const uint8_t *keep,
                     const double *packed, double *result)
{
    memcpy(result, packed, n * sizeof *result);
    uint32_t left = count(n, keep);
    for (uint32_t i = n; i-- > 0;)
        if (keep[i])
            result[i] = result[--left];
}

static void from_the_end(uint32_t n, const uint8_t *keep,
                         const double *packed, double *result)
{
    memcpy(result, packed, n * sizeof *result);
    uint32_t left = n;
    for (uint32_t i = n; i-- > 0;)
        result[i] = keep[i] ? result[--left] : hole;
}

static void one_too_far(uint32_t n, const uint8_t *keep,
                        const double *packed, double *result)
{
    memcpy(result, packed, n * sizeof *result);
    uint32_t left = count(n, keep);
    for (uint32_t i = n; i-- > 0;) {
        double value = left < n ? result[left] : hole;
        result[i] = keep[i] ? value : hole;
        left -= keep[i];
    }
}

static void not_the_first(uint32_t n, const uint8_t *keep,
                          const double *packed, double *result)
{
    unpack_right(n, keep, packed, result);
    result[0] = packed[0];
}

static const struct {
    void (*unpack)(uint32_t n, const uint8_t *keep,
                   const double *packed, double *result);
    const char *cause;
} mistakes[] = {
    {from_the_front,
     "Survivors are overwritten before they have moved. They move to "
     "the back, so the last one has to move first."},
    {no_holes, "Where the flag is not set, the old value is left: "
               "clear the place."},
    {from_the_end,
     "The values are taken from the end of the array. The survivors "
     "stand at its beginning: how many are there?"},
    {one_too_far,
     "Survivors are taken from one place too far. Of k survivors, the "
     "last one stands at place k - 1."},
    {not_the_first, "Place 0 is never written: does the loop end one "
                    "too early?"},
};

static const char *cause(uint32_t n, const uint8_t *keep,
                         const double *packed, const double *found)
{
    static double result[MOST];
    for (size_t m = 0; m < sizeof mistakes / sizeof *mistakes; m++) {
        mistakes[m].unpack(n, keep, packed, result);
        if (memcmp(found, result, n * sizeof *found) == 0)
            return mistakes[m].cause;
    }
    return "Follow your loop on paper with the flags 0 1 1 0 1.";
}

// Unpacks what a pack in place of 1, 2, 3, ... would have left.
static void check(uint32_t n, const uint8_t *keep)
{
    static double packed[MOST], right[MOST];
    uint32_t survivors = 0;
    for (uint32_t i = 0; i < n; i++)
        packed[i] = i + 1;
    for (uint32_t i = 0; i < n; i++)
        if (keep[i])
            packed[survivors++] = i + 1;
    unpack_right(n, keep, packed, right);
    places = n;
    values = kit_output("values", n, sizeof *values);
    memcpy(values, packed, n * sizeof *values);
    notes = kit_output("the counts", 1, sizeof *notes);
    *notes = (struct notes){.moves = 0};
    CALL(STUDENT(unpack)(n, keep));
    if (notes->outside)
        WRONG(.expected = kit_text("places below %u", n),
              .found = kit_text("place %u", notes->place),
              .cause = "Of k survivors, the last one stands at place "
                       "k - 1. Was there one left?");
    for (uint32_t i = 0; i < n; i++)
        if (values[i] != right[i])
            WRONG(.where = kit_text("values[%u], its flag is %d, %u of "
                                    "%u survive",
                                    i, keep[i], survivors, n),
                  .expected = kit_text("%.9g", right[i]),
                  .found = kit_text("%.9g", values[i]),
                  .cause = cause(n, keep, packed, values));
}

// And each place is written to once.
static void check_moves(uint32_t n, const uint8_t *keep)
{
    check(n, keep);
    const uint64_t written = notes->moves + notes->clears;
    if (written > n)
        WRONG(.expected = kit_text("%u moves and holes, one for each "
                                   "place",
                                   n),
              .found = kit_text("%ju moves and %ju holes",
                                (uintmax_t)notes->moves,
                                (uintmax_t)notes->clears),
              .cause = "A survivor can go straight to its place, if "
                       "nothing stands there that is still needed. For "
                       "which survivor is that certain?");
}

static uint8_t *flags(uint32_t n)
{
    return kit_input("keep", n, sizeof(uint8_t));
}

static void check_random(uint32_t n, double share, bool moves,
                         struct random *random)
{
    kit_given("%u values, each kept with probability %g", n, share);
    uint8_t *keep = flags(n);
    for (uint32_t i = 0; i < n; i++)
        keep[i] = random_uniform(random) < share;
    (moves ? check_moves : check)(n, keep);
    kit_next_case();
}

static void one_kept(uint32_t n, uint32_t kept)
{
    kit_given("%u values, only value %u is kept", n, kept);
    uint8_t *keep = flags(n);
    for (uint32_t i = 0; i < n; i++)
        keep[i] = i == kept;
    check(n, keep);
    kit_next_case();
}

static void all_or_none(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t n = 1; n <= 65; n += 16) {
        check_random(n, 1, false, &random);
        check_random(n, 0, false, &random);
    }
}

static void empty(uint64_t seed)
{
    (void)seed;
    kit_given("no values");
    check(0, flags(0));
}

static void one(uint64_t seed)
{
    (void)seed;
    for (uint32_t i = 0; i < 20; i++)
        one_kept(20, i);
}

static void every_second(uint64_t seed)
{
    (void)seed;
    for (uint32_t n = 2; n <= 41; n++) {
        kit_given("%u values, every second is kept", n);
        uint8_t *keep = flags(n);
        for (uint32_t i = 0; i < n; i++)
            keep[i] = i % 2;
        check_moves(n, keep);
        kit_next_case();
    }
}

static void short_ones(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t n = 0; n <= 100; n++)
        check_random(n, 0.5, false, &random);
}

static void long_ones(uint64_t seed)
{
    struct random random = {seed};
    check_random(MOST, 0.02, true, &random);
    check_random(MOST, 0.98, true, &random);
    check_random(MOST - 1, 0.5, true, &random);
}

const struct kit_test kit_tests[] = {
    {"empty", 1, "no values at all", empty},
    {"all-or-none", 1, "all values survive, or none", all_or_none},
    {"one", 1, "a single survivor, anywhere", one},
    {"short", 1, "0 to 100 values, random flags", short_ones},
    {"every-second", 2, "every second, each place written once",
     every_second},
    {"long", 4, "thousands, each place written once", long_ones},
    {0},
};
