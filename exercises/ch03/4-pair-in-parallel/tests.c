// Tests of the parallel nearest pair: answers under several numbers of
// threads, the pairs measured, ties with a thread that comes late, and
// lost updates in slow motion. No point hangs on luck: a program with
// nothing to guard its best pair has those for its loop, always, and
// none of those for the answer of threads that meet.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include "slow_motion.h"
#include <omp.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>

// What measure() answers and notes, in the student's process.
static const double *distances; // of pair i, j at place_of(i, j)
static struct notes {
    _Atomic uint32_t invalid; // calls for no pair
} * notes;
static _Atomic uint32_t *times; // each pair was measured
static uint32_t point_count;
static long first_row_ns, other_rows_ns; // what a call takes
static int threads_wanted; // and needed; 1: any number will do

static size_t place_of(uint32_t i, uint32_t j)
{
    return i < j ? (size_t)j * (j - 1) / 2 + i
                 : (size_t)i * (i - 1) / 2 + j;
}

double measure(uint32_t i, uint32_t j)
{
    kit_at_work(threads_wanted);
    if (i >= point_count || j >= point_count || i == j) {
        notes->invalid++;
        return 0;
    }
    long ns = i == 0 || j == 0 ? first_row_ns : other_rows_ns;
    if (ns > 0)
        nanosleep(&(struct timespec){.tv_nsec = ns}, NULL);
    times[place_of(i, j)]++;
    return distances[place_of(i, j)];
}

static struct pair search(uint32_t n)
{
    struct pair best = {0, 1, distances[0]};
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++)
            if (distances[place_of(i, j)] < best.distance2)
                best = (struct pair){i, j, distances[place_of(i, j)]};
    return best;
}

// Sets the distances of all pairs of n points; all alike if asked for.
static void prepare(uint32_t n, bool alike, uint64_t seed)
{
    size_t pairs = (size_t)n * (n - 1) / 2;
    struct random random = {seed};
    double *filled = kit_input("the distances", pairs, sizeof *filled);
    for (size_t p = 0; p < pairs; p++)
        filled[p] = alike ? 0.25 : 1 + random_uniform(&random);
    distances = filled;
    point_count = n;
    first_row_ns = other_rows_ns = 0;
    threads_wanted = 1;
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.invalid = 0};
    times = kit_output("the notes", pairs, sizeof *times);
    for (size_t p = 0; p < pairs; p++)
        times[p] = 0;
}

static const char *tell(struct pair pair)
{
    return kit_text("(%u, %u), squared distance %.17g", pair.i, pair.j,
                    pair.distance2);
}

static const char *cause(uint32_t n, struct pair right,
                         struct pair found)
{
    if (notes->invalid)
        return "measure() was asked about indices that are no pair.";
    if (found.distance2 < right.distance2 || found.i >= found.j ||
        found.j >= n)
        return "No pair is that near. What does each thread begin "
               "with, and what does a thread without work hand in?";
    if (found.distance2 != distances[place_of(found.i, found.j)])
        return "This is not the distance of this pair: indices and "
               "distance must change together.";
    if (found.distance2 == right.distance2)
        return "These tie, and this one was found by the thread that "
               "came first or last. Compare the indices, too, when "
               "threads hand in their results.";
    if (times[place_of(right.i, right.j)] == 0)
        return "The nearest pair was never measured.";
    return "It was measured and then forgotten. An update was lost, or "
           "some thread did not hand in its best pair, or a worse "
           "one replaced it.";
}

static struct pair *call(uint32_t n, int threads, bool slowly)
{
    struct pair *found = kit_output("the answer", 1, sizeof *found);
    kit_given("%u points, %d threads%s", n, threads,
              slowly ? ", in slow motion" : "");
    threads_wanted = n > 3 ? threads : 1;
    CALL(omp_set_num_threads(1); slow_motion(slowly);
         *found = STUDENT(nearest_pair)(n, threads));
    kit_expect_threads(threads_wanted);
    return found;
}

static void compare(uint32_t n, const struct pair *found)
{
    struct pair right = search(n);
    if (found->i != right.i || found->j != right.j ||
        found->distance2 != right.distance2)
        WRONG(.expected = tell(right), .found = tell(*found),
              .cause = cause(n, right, *found));
}

static void check(uint32_t n, int threads)
{
    compare(n, call(n, threads, false));
}

// Distances that all differ, and threads that nap before they write.
// About half of the trials lose an update that nothing guards; that all
// of forty do not, happens once in a million million gradings.
static void meet(uint64_t trials, uint64_t seed, const char *why)
{
    const uint32_t n = 4;
    for (uint64_t trial = 0; trial < trials; trial++) {
        prepare(n, false, seed + trial);
        first_row_ns = other_rows_ns = 100000; // too long for one
        const struct pair *found = call(n, 2 + trial % 3, true);
        struct pair right = search(n);
        if (memcmp(found, &right, sizeof right) != 0)
            WRONG(.where = kit_text("trial %ju", (uintmax_t)trial + 1),
                  .expected = tell(right), .found = tell(*found),
                  .cause = why);
        kit_next_case();
    }
}

// Where updates are lost, a right answer is luck.
static void guarded(uint64_t seed)
{
    enum { MEETINGS = 40 };
    meet(MEETINGS, seed + MEETINGS,
         "While updates are lost, a right answer is luck: make the "
         "test lost-updates pass first.");
}

static void right(uint64_t seed)
{
    guarded(seed);
    for (int threads = 1; threads <= 8; threads *= 2) {
        prepare(300, false, seed + threads);
        check(300, threads);
        kit_next_case();
    }
}

static void few_points(uint64_t seed)
{
    enum { TRIALS = 60 };
    for (uint64_t trial = 0; trial < TRIALS; trial++) {
        const uint32_t n = 2 + trial % 5;
        prepare(n, false, seed + trial);
        compare(n, call(n, 8, true));
        kit_next_case();
    }
}

// What comes of it is not the question here.
static void once(uint64_t seed)
{
    const uint32_t n = 100;
    prepare(n, false, seed);
    call(n, 4, false);
    for (uint32_t i = 0; i < n; i++)
        for (uint32_t j = i + 1; j < n; j++) {
            uint32_t found = times[place_of(i, j)];
            if (found != 1)
                WRONG(.where = kit_text("pair (%u, %u)", i, j),
                      .expected = "measured once",
                      .found = kit_text("%u times", found),
                      .cause = found == 0 ? "It was left out."
                               : found == 2
                                   ? "Is it measured as (j, i), too?"
                                   : "As it seems, every thread runs "
                                     "the whole loop: share it with "
                                     "#pragma omp for.");
        }
}

// Every row takes its time, so that no thread can do it all alone. Who
// works is the question here, and not what comes of it.
static void shared(uint64_t seed)
{
    for (int threads = 2; threads <= 4; threads++) {
        prepare(8, false, seed);
        first_row_ns = other_rows_ns = 1000000;
        call(8, threads, false);
        kit_next_case();
    }
}

// All pairs tie; the thread with the winner comes last, then first.
static void ties(uint64_t seed)
{
    enum { TRIALS = 12 };
    guarded(seed);
    const long soon = 2000000, late = 10000000;
    for (int trial = 0; trial < TRIALS; trial++) {
        prepare(4, true, seed);
        first_row_ns = trial % 2 ? soon : late;
        other_rows_ns = trial % 2 ? late : soon;
        check(4, 2 + trial / 2 % 2);
        kit_next_case();
    }
}

static void lost_updates(uint64_t seed)
{
    enum { TRIALS = 60 };
    meet(TRIALS, seed,
         "An update was lost, or two were mixed: while one thread "
         "slept, another wrote, too. The comparison with the common "
         "best pair and its update belong into one critical region.");
}

const struct kit_test kit_tests[] = {
    {"once", 2, "every pair is measured once", once},
    {"shared", 1, "several threads work", shared},
    {"lost-updates", 3, "no update is lost", lost_updates},
    {"right", 1, "the nearest of 300 points", right},
    {"few-points", 1, "more threads than points", few_points},
    {"ties", 2, "ties, whichever thread comes first", ties},
    {0},
};
