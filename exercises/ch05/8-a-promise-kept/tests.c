// Tests of the stack of arrays: a caller takes them, fills them, looks
// at them again and gives them up; and the system counts the page
// faults, against the pages that the caller itself touches.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

enum {
    MB = 1 << 20,
    ALIGNED = 64,
    SPARE = 64, // pages that only we touch
    STRAY = 24, // faults that have nothing to do with arrays
    STEPS = 8,
    HELD_MAX = 30, // arrays at a time
};

// In the student's process, which ends with the first fault.
static struct notes {
    enum fault {
        NOTHING,
        SPENT,   // fresh was asked for more than there is
        STRANGE, // an array that is not of fresh
        CROOKED,
        SHARED, // with an array that is still there
        CHANGED,
        DIRTY,
    } fault;
    size_t bytes, place; // of the array
    size_t promised;
    bool counted;      // the system counts page by page
    long first, later; // page faults of the first step, and the others
} * notes;

static char *memory; // the system's
static size_t page;

static struct held {
    unsigned char *array, filled;
    size_t bytes, height; // of the stack below it
} held[HELD_MAX];
static int held_count;

static _Noreturn void stop(enum fault fault, size_t bytes, size_t place)
{
    notes->fault = fault;
    notes->bytes = bytes;
    notes->place = place;
    kit_leave();
}

void *fresh(size_t bytes)
{
    if (bytes > MOST - notes->promised)
        stop(SPENT, bytes, 0);
    char *begin = memory + notes->promised;
    notes->promised += (bytes + page - 1) / page * page;
    return begin;
}

static long faults(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

// Small pages, each of which is a fault; the last ones are our own, to
// see whether the system counts.
static void begin(void)
{
    const size_t all = MOST + SPARE * page;
    memory = mmap(NULL, all, PROT_READ | PROT_WRITE,
                  MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
#ifdef MADV_NOHUGEPAGE
    madvise(memory, all, MADV_NOHUGEPAGE);
#endif
    *notes = (struct notes){.fault = NOTHING};
    held_count = 0;
    const long before = faults();
    for (size_t k = 0; k < SPARE; k++)
        memory[MOST + k * page] = 1;
    const long found = faults() - before;
    notes->counted = found >= SPARE && found <= SPARE + STRAY;
}

// ---- the caller ----------------------------------------------------

// The first byte that is not as it was filled, or bytes.
static size_t differs(const unsigned char *array, size_t bytes,
                      unsigned char filled)
{
    if (bytes == 0 || (array[0] == filled &&
                       memcmp(array, array + 1, bytes - 1) == 0))
        return bytes;
    size_t k = 0;
    while (array[k] == filled)
        k++;
    return k;
}

static void check_array(const unsigned char *array, size_t bytes)
{
    const uintptr_t at = (uintptr_t)array, from = (uintptr_t)memory;
    if (at < from || at - from > notes->promised ||
        bytes > notes->promised - (at - from))
        stop(STRANGE, bytes, 0);
    if (at % ALIGNED != 0)
        stop(CROOKED, bytes, at % ALIGNED);
}

// Takes an array, of which so many bytes must be 0 if it is cleared.
static unsigned char *take_one(size_t bytes, bool cleared,
                               size_t looked)
{
    const size_t below = STUDENT(height)();
    unsigned char *array =
        cleared ? STUDENT(take_cleared)(bytes) : STUDENT(take)(bytes);
    check_array(array, bytes);
    for (int h = 0; h < held_count; h++)
        if (array < held[h].array + held[h].bytes &&
            held[h].array < array + bytes)
            stop(SHARED, bytes, held[h].bytes);
    const size_t dirty = differs(array, looked, 0);
    if (cleared && dirty < looked)
        stop(DIRTY, bytes, dirty);
    held[held_count++] = (struct held){array, 0, bytes, below};
    return array;
}

// If it is cleared, its zeros are looked at, unless nothing has been
// there: to look at a fresh page is a fault, and to write to it
// another.
static void take_and_fill(size_t bytes, bool cleared, bool looked)
{
    static unsigned char last;
    unsigned char *array =
        take_one(bytes, cleared, cleared && looked ? bytes : 0);
    last = last % 255 + 1;
    held[held_count - 1].filled = last;
    memset(array, last, bytes);
}

// Back to so many arrays, if all are as they were filled.
static void release(int count)
{
    for (int h = 0; h < held_count; h++) {
        const struct held x = held[h];
        const size_t at =
            x.filled ? differs(x.array, x.bytes, x.filled) : x.bytes;
        if (at < x.bytes)
            stop(CHANGED, x.bytes, at);
    }
    if (count < held_count)
        STUDENT(back_to)(held[count].height);
    held_count = count;
}

static void at_random(uint64_t seed)
{
    begin();
    struct random random = {seed};
    for (int k = 0; k < 2000; k++) {
        const uint64_t bits = random_bits(&random);
        if (held_count == HELD_MAX || bits % 4 == 0)
            release(held_count > 0 ? (bits >> 8) % held_count : 0);
        else
            take_and_fill((bits >> 8) % (bits & 16 ? 200 : 9000),
                          bits % 4 == 1, true);
    }
    release(0);
}

// The second array is given up before the third is taken.
static void in_steps(const size_t *megabytes, bool cleared)
{
    begin();
    for (int s = 0; s < STEPS; s++) {
        const long before = faults();
        take_and_fill(megabytes[0] * MB - 100, cleared, s > 0);
        take_and_fill(megabytes[1] * MB, cleared, s > 0);
        release(1);
        take_and_fill(megabytes[2] * MB - 5000, cleared, true);
        release(0);
        *(s == 0 ? &notes->first : &notes->later) += faults() - before;
    }
}

enum { LARGE = 25, LOOKED = 2, MARKS = 5 };

// A little is used, and given up; then two large arrays are cleared, of
// which hardly anything is used.
static void hardly_touched(void)
{
    begin();
    take_and_fill(MB, false, false);
    release(0);
    const long before = faults();
    for (int a = 0; a < 2; a++) {
        unsigned char *array = take_one((size_t)LARGE * MB, true,
                                        a == 0 ? LOOKED * MB : 0);
        for (int k = 0; k < MARKS; k++)
            array[(size_t)(LOOKED + 4 * k) * MB] = 1;
    }
    notes->first = faults() - before;
}

enum { SMALL = 40, MANY = 5000 };

static void many_small_ones(void)
{
    static unsigned char *array[MANY];
    begin();
    memset(array, 0, sizeof array); // these pages are not the student's
    for (int round = 1; round <= 2; round++) {
        const long before = faults();
        const size_t below = STUDENT(height)();
        for (int k = 0; k < MANY; k++) {
            array[k] = STUDENT(take)(SMALL);
            check_array(array[k], SMALL);
            memset(array[k], k % 251 + round, SMALL);
        }
        for (int k = 0; k < MANY; k++) {
            const size_t at = differs(array[k], SMALL, k % 251 + round);
            if (at < SMALL)
                stop(CHANGED, SMALL, at);
        }
        STUDENT(back_to)(below);
        *(round == 1 ? &notes->first : &notes->later) +=
            faults() - before;
    }
}

// ---- the judge -----------------------------------------------------

static void tell(void)
{
    const char *array = kit_text("an array of %zu bytes", notes->bytes);
    switch (notes->fault) {
    case SPENT:
        WRONG(.expected =
                  kit_text("at most %d MB of fresh in all", MOST / MB),
              .found = kit_text("%.2f MB more, after %.2f MB",
                                (double)notes->bytes / MB,
                                (double)notes->promised / MB),
              .cause = "So much is never needed at a time. Is memory "
                       "used again that was given up, and do small "
                       "arrays lie side by side?");
    case STRANGE:
        WRONG(.where = array, .expected = "memory that fresh gave",
              .found = kit_text("another address, after %zu MB",
                                notes->promised / MB),
              .cause = "More is taken than fresh gave, or it has never "
                       "been asked. Is memory used again that was "
                       "given up?");
    case CROOKED:
        WRONG(.where = array,
              .expected = kit_text("a multiple of %d", ALIGNED),
              .found = kit_text("%zu more than that", notes->place),
              .cause = "What is taken must be rounded up, or the next "
                       "array begins anywhere.");
    case SHARED:
        WRONG(.where = array, .expected = "memory of its own",
              .found = kit_text("memory of an array of %zu bytes, "
                                "which is still there",
                                notes->place),
              .cause = "Does the stack rise by what is taken, and fall "
                       "no further than it is told?");
    case CHANGED:
        WRONG(.where = kit_text("byte %zu of %s", notes->place, array),
              .expected = "what was written there",
              .found = "something else",
              .cause = "What is cleared must not reach into arrays "
                       "that were taken before.");
    case DIRTY:
        WRONG(.where = kit_text("byte %zu of %s", notes->place, array),
              .expected = "0",
              .found = "what an earlier array had there",
              .cause = "Only memory that nobody has ever taken is 0 "
                       "by itself. How high has the stack been?");
    default:
        break;
    }
}

static const char *cause_of(long first)
{
    if (first >= MANY && first < MANY + MANY / 10)
        return "Does every small array begin a page of its own? Many "
               "of them can lie side by side in one.";
    return "Pages are touched that nobody needed yet. Fresh memory is "
           "0 already; and to look at a page is to touch it, too.";
}

// All must be as it was filled, and the first step may touch so many
// pages, the others none.
static void check_faults(size_t pages)
{
    tell();
    if (kit_is_sanitized()) // which touches pages of its own
        return;
    if (!notes->counted)
        kit_not_graded("this system does not count page faults one "
                       "by one");
    const long first = notes->first, later = notes->later;
    if (first > (long)pages + STRAY)
        WRONG(.expected = kit_text("at most %zu page faults at first",
                                   pages + STRAY),
              .found = kit_text("%ld", first),
              .cause = cause_of(first));
    if (later > STRAY)
        WRONG(.expected = "no page fault after the first step",
              .found = kit_text("%ld", later),
              .cause = "These pages had been there. Were they given "
                       "back to the system, or do new arrays lie "
                       "elsewhere?");
}

static void prepare(void)
{
    page = sysconf(_SC_PAGESIZE);
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.fault = NOTHING};
}

static size_t pages_of(size_t bytes)
{
    return bytes / page + 1;
}

static void right(uint64_t seed)
{
    prepare();
    kit_given("arrays of up to 9,000 bytes, at random");
    CALL(at_random(seed));
    tell();
}

static void steps(bool cleared)
{
    static const size_t megabytes[] = {3, 5, 4};
    prepare();
    kit_given("%d steps with %sarrays of 3, 5 and 4 MB, the last in "
              "place of the second",
              STEPS, cleared ? "cleared " : "");
    CALL(in_steps(megabytes, cleared));
    check_faults(pages_of((3 + 5) * (size_t)MB));
}

static void kept(uint64_t seed)
{
    (void)seed;
    steps(false);
}

static void kept_clear(uint64_t seed)
{
    (void)seed;
    steps(true);
}

static void untouched(uint64_t seed)
{
    (void)seed;
    prepare();
    kit_given("two arrays of %d MB, cleared, and hardly used", LARGE);
    CALL(hardly_touched());
    check_faults(pages_of(LOOKED * (size_t)MB) + 2 * MARKS);
}

static void small(uint64_t seed)
{
    (void)seed;
    prepare();
    kit_given("twice %d arrays of %d bytes", MANY, SMALL);
    CALL(many_small_ones());
    check_faults(pages_of((size_t)MANY * ALIGNED));
}

const struct kit_test kit_tests[] = {
    {"right", 2, "arrays of their own, which stay as they are", right},
    {"kept", 3, "no page fault after the first step", kept},
    {"cleared", 2, "nor where arrays are cleared", kept_clear},
    {"untouched", 2, "no page for what is never used", untouched},
    {"small", 1, "small arrays share pages", small},
    {0},
};
