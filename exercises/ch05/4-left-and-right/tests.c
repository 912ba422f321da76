// Tests of the parallel partition: answers under several numbers of
// threads, threads that come late, fewer threads than asked for, and
// lost updates in slow motion.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include "slow_motion.h"
#include <omp.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>

static const uint32_t unset = 0xa5a5a5a5; // in a new output

// What is_left() answers and notes, in the student's process.
static const bool *sides;
static struct notes {
    _Atomic uint32_t invalid; // calls for no point
} * notes;
static _Atomic uint32_t *asked; // how often, for each point
static uint32_t point_count;
static uint32_t slow_from, slow_to; // these points take their time
static long slow_ns;
static int threads_wanted; // and needed; 1: any number will do

bool is_left(uint32_t i)
{
    kit_at_work(threads_wanted);
    if (i >= point_count) {
        notes->invalid++;
        return false;
    }
    if (slow_from <= i && i < slow_to)
        nanosleep(&(struct timespec){.tv_nsec = slow_ns}, NULL);
    asked[i]++;
    return sides[i];
}

static void prepare(uint32_t n, uint64_t seed)
{
    struct random random = {seed};
    bool *filled = kit_input("the sides", n, sizeof *filled);
    for (uint32_t i = 0; i < n; i++)
        filled[i] = random_bits(&random) % 5 < 2;
    sides = filled;
    point_count = n;
    slow_from = slow_to = 0;
    threads_wanted = 1;
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.invalid = 0};
    asked = kit_output("the notes", n, sizeof *asked);
    for (uint32_t i = 0; i < n; i++)
        asked[i] = 0;
}

static void all_on_side(uint32_t n, bool left)
{
    prepare(n, 0);
    bool *filled = kit_input("the sides", n, sizeof *filled);
    memset(filled, left, n);
    sides = filled;
}

struct result {
    uint32_t lefts;
    uint32_t *point;
};

static struct result solve(uint32_t n)
{
    struct result right = {0, kit_input("right", n, sizeof(uint32_t))};
    for (uint32_t i = 0; i < n; i++)
        if (sides[i])
            right.point[right.lefts++] = i;
    uint32_t r = right.lefts;
    for (uint32_t i = 0; i < n; i++)
        if (!sides[i])
            right.point[r++] = i;
    return right;
}

static uint32_t times_found(uint32_t n, const uint32_t *point,
                            uint32_t i)
{
    uint32_t times = 0;
    for (uint32_t k = 0; k < n; k++)
        times += point[k] == i;
    return times;
}

// The first point that is not there, or n.
static uint32_t missing(uint32_t n, const uint32_t *point)
{
    uint32_t i = 0;
    while (i < n && times_found(n, point, i) > 0)
        i++;
    return i;
}

static const char *count_cause(struct result right, uint32_t found)
{
    if (found > right.lefts)
        return "Some points were counted more than once: does every "
               "thread count only its own, and from zero?";
    return "Not all points on the left were counted. Threads that add "
           "to one variable lose updates, and a sum taken before "
           "all have counted is too small: it takes a barrier.";
}

static const char *place_cause(uint32_t n, const uint32_t *found,
                               uint32_t lefts)
{
    uint32_t lost = missing(n, found);
    if (lefts > 0 && found[0] == unset)
        return "The first place was left free. A thread's places begin "
               "behind the points of the threads before it; its own do "
               "not count.";
    for (uint32_t k = 0; k < n; k++)
        if (found[k] < n && sides[found[k]] != (k < lefts))
            return "A point is on the wrong side. A thread's right "
                   "ones "
                   "stand behind the left ones of all threads, and "
                   "every thread waits until all counts are summed.";
    if (lost < n)
        return kit_text("Point %u stands nowhere. If it was placed, "
                        "then something else in the same place: was "
                        "anything placed before all counts were "
                        "summed?",
                        lost);
    return "All are on their side, but not in ascending order: they "
           "took their places as they came. Each thread has "
           "consecutive points, and knows beforehand which places are "
           "its own, behind those of the threads before it.";
}

static void judge(uint32_t n, int threads, const uint32_t *lefts,
                  const uint32_t *point)
{
    struct result right = solve(n);
    if (notes->invalid)
        WRONG(.cause = "is_left() was called with numbers that no "
                       "point has.");
    kit_expect_threads(threads_wanted);
    for (uint32_t i = 0; i < n; i++)
        if (asked[i] == 0)
            WRONG(.where = kit_text("point %u", i),
                  .expected = "some thread calls is_left for it",
                  .found = "none does",
                  .cause = i >= n / threads * threads
                               ? "n / threads is rounded down, and the "
                                 "last points have no thread."
                               : "Each point has to be some thread's.");
    if (*lefts != right.lefts)
        WRONG(.expected = kit_text("%u on the left", right.lefts),
              .found = kit_text("%u", *lefts),
              .cause = count_cause(right, *lefts));
    for (uint32_t k = 0; k < n; k++)
        if (point[k] != right.point[k])
            WRONG(.where = kit_text("point[%u]", k),
                  .expected = kit_text("%u", right.point[k]),
                  .found = point[k] == unset ? "never set"
                                             : kit_text("%u", point[k]),
                  .cause = place_cause(n, point, *lefts));
}

// Calls in the way that is asked for, and judges.
enum manner { PLAIN, INSIDE, SLOW };

static uint32_t inside(__typeof__(&divide) student, uint32_t n,
                       uint32_t *point, int threads)
{
    uint32_t lefts = 0;
    omp_set_max_active_levels(1);
#pragma omp parallel num_threads(2)
#pragma omp single
    lefts = student(n, point, threads);
    return lefts;
}

static void check(uint32_t n, int threads, enum manner manner)
{
    uint32_t *lefts = kit_output("the answer", 1, sizeof *lefts);
    uint32_t *point = kit_output("point", n, sizeof *point);
    threads_wanted = manner != INSIDE && n > 9 ? threads : 1;
    switch (manner) {
    case PLAIN:
        kit_given("%u points, %d threads", n, threads);
        CALL(omp_set_num_threads(1);
             *lefts = STUDENT(divide)(n, point, threads));
        break;
    case INSIDE:
        kit_given("%u points, %d threads asked for, one given", n,
                  threads);
        CALL(*lefts = inside(STUDENT(divide), n, point, threads));
        if (missing(n, point) < n || *lefts != solve(n).lefts)
            WRONG(.expected = "all the work, done by one thread",
                  .found =
                      missing(n, point) < n
                          ? kit_text("point %u in no place",
                                     missing(n, point))
                          : kit_text("%u on the left, which are %u",
                                     *lefts, solve(n).lefts),
                  .cause = "The work of threads that did not come was "
                           "left undone. omp_get_num_threads(), inside "
                           "of the region, says how many came.");
        break;
    case SLOW:
        kit_given("%u points, %d threads, in slow motion", n, threads);
        CALL(omp_set_num_threads(1); slow_motion(true);
             *lefts = STUDENT(divide)(n, point, threads));
        break;
    }
    judge(n, threads, lefts, point);
}

static void right(uint64_t seed)
{
    for (int threads = 1; threads <= 8; threads *= 2) {
        prepare(1000 + threads / 2, seed + threads);
        check(point_count, threads, PLAIN);
        kit_next_case();
    }
}

static void few_points(uint64_t seed)
{
    for (uint32_t n = 0; n <= 9; n++) {
        prepare(n, seed + n);
        check(n, 8, PLAIN);
        kit_next_case();
    }
    for (int left = 0; left <= 1; left++) {
        all_on_side(50, left);
        check(50, 4, PLAIN);
        kit_next_case();
    }
}

static void twice(uint64_t seed)
{
    prepare(100, seed);
    check(100, 4, PLAIN);
    for (uint32_t i = 0; i < 100; i++)
        if (asked[i] > 2)
            WRONG(.where = kit_text("point %u", i),
                  .expected = "at most two calls of is_left",
                  .found = kit_text("%u times", asked[i]),
                  .cause = "Once to count and once to place is enough. "
                           "Does every thread look at its own points "
                           "only?");
}

// Every point takes its time, so that no thread can do it all alone.
static void shared(uint64_t seed)
{
    for (int threads = 2; threads <= 4; threads++) {
        prepare(24, seed);
        slow_to = 24, slow_ns = 1000000;
        check(24, threads, PLAIN);
        if (kit_threads() != threads)
            WRONG(.expected = kit_text("%d threads at work", threads),
                  .found = kit_text("%d", kit_threads()),
                  .cause = "A parallel region has as many threads as "
                           "its clause num_threads(threads) says, and "
                           "each needs some of the points.");
        kit_next_case();
    }
}

// One thread after the other comes late.
static void late(uint64_t seed)
{
    enum { N = 40 };
    for (int threads = 2; threads <= 4; threads += 2)
        for (int t = 0; t < threads; t++) {
            prepare(N, seed);
            slow_from = N * t / threads;
            slow_to = N * (t + 1) / threads;
            slow_ns = 1000000;
            check(N, threads, PLAIN);
            kit_next_case();
        }
}

static void fewer(uint64_t seed)
{
    prepare(100, seed);
    check(100, 4, INSIDE);
}

static void lost_updates(uint64_t seed)
{
    enum { TRIALS = 40 };
    for (int trial = 0; trial < TRIALS; trial++) {
        prepare(16, seed + trial);
        check(16, 2 + trial % 3, SLOW);
        kit_next_case();
    }
}

const struct kit_test kit_tests[] = {
    {"right", 2, "a thousand points, 1 to 8 threads", right},
    {"few-points", 1, "fewer points than threads", few_points},
    {"twice", 1, "at most two calls of is_left for a point", twice},
    {"shared", 1, "all threads work", shared},
    {"late", 2, "threads that come late", late},
    {"fewer", 1, "fewer threads than asked for", fewer},
    {"lost-updates", 2, "no update is lost", lost_updates},
    {0},
};
