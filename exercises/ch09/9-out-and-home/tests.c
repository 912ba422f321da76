// Tests of the ways out and home: the orders, and how many lines had to
// be fetched. Far memory and its cache live in the student's process.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

enum { ARRAYS = 4, LINES = (RECORDS_MOST + LINE - 1) / LINE };
static const char *const array_names[] = {"INPUT", "ROOM", "SORTED",
                                          "OUTPUT"};

static uint32_t n;
static struct record *far[ARRAYS];

// What the student's process leaves behind.
static struct notes {
    uint64_t fetched[ARRAYS];
    bool bad;
    uint32_t bad_array, bad_place;
} * notes;

// ---- far memory ----------------------------------------------------

// The lines in the cache, a ring from the one used last to the one used
// first; line 0 is none, and begins the ring.
static struct {
    uint32_t before[ARRAYS * LINES + 1], after[ARRAYS * LINES + 1];
    bool inside[ARRAYS * LINES + 1];
    uint32_t count;
} cache;

static void take_out(uint32_t line)
{
    cache.after[cache.before[line]] = cache.after[line];
    cache.before[cache.after[line]] = cache.before[line];
    cache.inside[line] = false;
    cache.count--;
}

static void put_first(uint32_t line)
{
    cache.before[line] = 0;
    cache.after[line] = cache.after[0];
    cache.before[cache.after[0]] = line;
    cache.after[0] = line;
    cache.inside[line] = true;
    cache.count++;
}

static struct record *reach(enum array array, uint32_t place)
{
    if ((unsigned)array >= ARRAYS || place >= n) {
        notes->bad = true;
        notes->bad_array = array;
        notes->bad_place = place;
        kit_leave();
    }
    const uint32_t line = 1 + array * LINES + place / LINE;
    if (cache.inside[line])
        take_out(line);
    else
        notes->fetched[array]++;
    put_first(line);
    if (cache.count > CACHE)
        take_out(cache.before[0]);
    return &far[array][place];
}

struct record get(enum array array, uint32_t place)
{
    return *reach(array, place);
}

void set(enum array array, uint32_t place, struct record record)
{
    *reach(array, place) = record;
}

// ---- inputs --------------------------------------------------------

static struct record *given; // in INPUT, or in SORTED

static int by_cell(const void *one, const void *other)
{
    const struct record *a = one, *b = other;
    if (a->cell != b->cell)
        return a->cell < b->cell ? -1 : 1;
    return (a->index > b->index) - (a->index < b->index);
}

// Points in cells at random, of so many cells; or, on the way home, in
// the order of these cells.
static void prepare(uint32_t count, uint32_t cells, bool home,
                    uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = count;
    given = kit_input("the points", n, sizeof *given);
    for (uint32_t i = 0; i < n; i++)
        given[i] = (struct record){i, random_bits(&random) % cells};
    if (home)
        qsort(given, n, sizeof *given, by_cell);
    for (int a = 0; a < ARRAYS; a++)
        far[a] = kit_output(array_names[a], n, sizeof *far[a]);
    memcpy(far[home ? SORTED : INPUT], given, n * sizeof *given);
    notes = kit_output("the counts", 1, sizeof *notes);
    *notes = (struct notes){.bad = false};
    kit_given("%u points in %u cells", n, cells);
}

// ---- answers -------------------------------------------------------

static void check_bad(void)
{
    if (!notes->bad)
        return;
    const bool known = notes->bad_array < ARRAYS;
    WRONG(.expected = kit_text("places below %u of the four arrays", n),
          .found = kit_text("place %u of %s", notes->bad_place,
                            known ? array_names[notes->bad_array]
                                  : "another array"),
          .cause = "Does each bucket begin where the one before it "
                   "ends, and are there as many as it takes?");
}

static const char *tell(struct record record)
{
    if (record.index >= n)
        return "nothing that was ever there";
    return kit_text("point %u, of cell %u", record.index, record.cell);
}

static void check_out(void)
{
    CALL(STUDENT(go_out)(n));
    check_bad();
    qsort(given, n, sizeof *given, by_cell);
    for (uint32_t s = 0; s < n; s++) {
        const struct record found = far[SORTED][s];
        if (memcmp(&found, &given[s], sizeof found) == 0)
            continue;
        WRONG(.where = kit_text("place %u of SORTED", s),
              .expected = tell(given[s]), .found = tell(found),
              .cause = found.index == s
                           ? "These stand in the order of the input."
                       : found.index < n && found.cell == given[s].cell
                           ? "The cell is right, but points of a cell "
                             "keep their order: so must each pass."
                           : "Is each bucket sorted by cell, and does "
                             "it begin where the one before it ends?");
    }
}

static void check_home(void)
{
    CALL(STUDENT(go_home)(n));
    check_bad();
    for (uint32_t i = 0; i < n; i++) {
        const struct record found = far[OUTPUT][i];
        if (found.index != i)
            WRONG(.where = kit_text("place %u of OUTPUT", i),
                  .expected = kit_text("the result of point %u", i),
                  .found = tell(found),
                  .cause =
                      memcmp(&found, &given[i], sizeof found) == 0
                          ? "These stand in the order of SORTED."
                          : "A result's index is its place in OUTPUT. "
                            "Has the last bucket been brought home, "
                            "which may not be full?");
    }
}

// ---- lines ---------------------------------------------------------

static const char *cause(enum array target)
{
    if (2 * notes->fetched[ROOM] > n)
        return "There are so many buckets that their open lines do not "
               "fit into the cache. Make them larger.";
    if (2 * notes->fetched[target] > n && notes->fetched[ROOM] == 0)
        return "Almost each record is written to a line that is not in "
               "the cache. Carry it first to one of a few hundred "
               "buckets, whose last lines all fit into it.";
    if (3 * notes->fetched[target] > n)
        return "A bucket, and the places to which its records go, must "
               "fit into the cache. Make them smaller.";
    return "Each array need be gone through once or twice. Is one of "
           "them read more often?";
}

static void check_lines(const struct kit_band *bands, enum array target)
{
    uint64_t fetched = 0;
    for (int a = 0; a < ARRAYS; a++)
        fetched += notes->fetched[a];
    kit_bands(
        (double)fetched / n, bands,
        (struct kit_fault){
            .expected =
                kit_text("at most %g lines a point", bands[0].most),
            .found = kit_text("%.2f: of INPUT %ju lines, of ROOM %ju, "
                              "of SORTED %ju, of OUTPUT %ju",
                              (double)fetched / n,
                              (uintmax_t)notes->fetched[INPUT],
                              (uintmax_t)notes->fetched[ROOM],
                              (uintmax_t)notes->fetched[SORTED],
                              (uintmax_t)notes->fetched[OUTPUT]),
            .cause = cause(target)});
}

// ---- tests ---------------------------------------------------------

static const struct {
    uint32_t n, cells;
} sets[] = {{0, 1},       {1, 1},       {2, 2},     {8, 8},
            {9, 3},       {100, 1},     {511, 511}, {512, 512},
            {1025, 1025}, {3000, 2000}, {20000, 7}, {30000, 30000}};
enum { SETS = sizeof sets / sizeof *sets };

static void out(uint64_t seed)
{
    for (int k = 0; k < SETS; k++) {
        prepare(sets[k].n, sets[k].cells, false, seed + k);
        check_out();
    }
}

static void home(uint64_t seed)
{
    for (int k = 0; k < SETS; k++) {
        prepare(sets[k].n, sets[k].cells, true, seed + k);
        check_home();
    }
}

static void out_lines(uint64_t seed)
{
    static const uint32_t many[] = {RECORDS_MOST, 60000};
    for (int k = 0; k < 2; k++) {
        prepare(many[k], many[k], false, seed);
        check_out();
        check_lines((struct kit_band[]){{0.75, 3}, {0.95, 1}, {0, 0}},
                    SORTED);
    }
}

static void home_lines(uint64_t seed)
{
    static const uint32_t many[] = {RECORDS_MOST, 60000};
    for (int k = 0; k < 2; k++) {
        prepare(many[k], many[k], true, seed);
        check_home();
        check_lines((struct kit_band[]){{0.6, 3}, {0.8, 1}, {0, 0}},
                    OUTPUT);
    }
}

const struct kit_test kit_tests[] = {
    {"out", 2, "the order of the cells", out},
    {"home", 2, "each result at its point's place", home},
    {"out-lines", 3, "three quarters of a line a point, out",
     out_lines},
    {"home-lines", 3, "six tenths of a line a point, home", home_lines},
    {0},
};
