// Tests of the lock: one thread at a time, in slow motion, too; the
// order of arrival; attempts that do not wait; and numbers that begin
// near the end of their range. A lock that does not keep threads apart
// has no points for their order.
#include "exercise.h"
#include "kit.h"
#include "slow_motion.h"
#include <omp.h>
#include <time.h>

enum { THREADS = 5, PAUSES = 5000 };

// In the student's process: who is inside, and what was seen.
static struct notes {
    _Atomic uint32_t inside, together; // threads; the most at a time
    _Atomic uint32_t pauses;
    _Atomic bool endless, waited; // waited: in an attempt
    _Atomic uint32_t arrived, entered;
    uint32_t arrival[THREADS];
    uint32_t entry[THREADS]; // which of the arrivals came in
    bool tried[8];
    uint32_t numbers[2]; // next and serving, at the end
} * notes;
static struct lock *lock; // and a second one behind it
static _Thread_local bool trying;
static uint32_t first_number; // of both

static void sleep_us(long us)
{
    nanosleep(&(struct timespec){.tv_nsec = us * 1000}, NULL);
}

void pause_before_next_look(void)
{
    if (trying)
        notes->waited = true;
    if (notes->pauses++ >= PAUSES) {
        notes->endless = true;
        kit_leave();
    }
    sleep_us(20 + notes->pauses * 7919 % 16 * 20);
}

static void prepare(uint32_t begin)
{
    first_number = begin;
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.inside = 0};
    lock = kit_output("the locks", 2, sizeof *lock);
    for (int k = 0; k < 2; k++) {
        lock[k].next = begin;
        lock[k].serving = begin;
    }
    kit_given("a lock whose two numbers begin at %u", begin);
}

static bool attempt(__typeof__(&try_acquire) try, struct lock *which)
{
    trying = true;
    bool taken = try(which);
    trying = false;
    return taken;
}

// What a thread does with the lock: it notes how many are there.
static void stay_inside(long us)
{
    uint32_t there = ++notes->inside;
    if (there > notes->together)
        notes->together = there;
    sleep_us(us);
    notes->inside--;
}

// Faults that small numbers do not have are those of the largest.
static const char *cause(const char *usual)
{
    return first_number < UINT32_MAX / 2
               ? usual
               : "With small numbers the same was right. After the "
                 "largest number comes 0: compare whether numbers are "
                 "equal, not which is smaller.";
}

static void refuse_endless(const char *where)
{
    if (notes->endless)
        WRONG(.where = where, .expected = "an end of the waiting",
              .found = kit_text("%d pauses, and still waiting", PAUSES),
              .cause = cause(
                  "The number that this thread waits for is never "
                  "served. Does each release serve the next "
                  "number, and no other? Has a thread drawn a "
                  "number that it does not wait for, or two "
                  "the same, because it is not read and moved on "
                  "in a single atomic step?"));
}

static void refuse_company(void)
{
    refuse_endless("several threads");
    if (notes->together > 1)
        WRONG(.expected = "one thread at a time",
              .found = kit_text("%u inside together", notes->together),
              .cause = cause(
                  "Between a look and a store, another thread may "
                  "look, too, and see the same. The number of a "
                  "thread must be read and moved on in a single "
                  "atomic step."));
}

// ---- one thread ----------------------------------------------------

static void use_alone(uint32_t turns)
{
    __typeof__(&acquire) take = STUDENT(acquire);
    __typeof__(&release) give = STUDENT(release);
    for (uint32_t k = 0; k < turns; k++) {
        take(lock);
        give(lock);
    }
    notes->numbers[0] = lock->next;
    notes->numbers[1] = lock->serving;
}

static void check_alone(uint32_t begin, uint32_t turns)
{
    prepare(begin);
    CALL(use_alone(turns));
    refuse_endless("a single thread");
    if (notes->numbers[0] != notes->numbers[1])
        WRONG(.where = "at the end",
              .expected = "two equal numbers: the lock is free",
              .found = kit_text("next %u, serving %u",
                                notes->numbers[0], notes->numbers[1]),
              .cause = cause(
                  "What release leaves behind must be a lock that "
                  "is free."));
    kit_next_case();
}

static void alone(uint64_t seed)
{
    (void)seed;
    check_alone(0, 1);
    check_alone(7, 1000);
}

static void use_two(void)
{
    STUDENT(acquire)(lock);
    STUDENT(acquire)(lock + 1);
    STUDENT(release)(lock);
    STUDENT(acquire)(lock);
    STUDENT(release)(lock + 1);
    STUDENT(release)(lock);
}

static void separate(uint64_t seed)
{
    (void)seed;
    prepare(0);
    CALL(use_two());
    if (notes->endless)
        WRONG(.where = "a second lock", .expected = "it is free",
              .found = "a thread that waits for it for ever",
              .cause = "A lock is its two numbers. What one of them "
                       "knows must not stand in a global variable.");
}

static void use_tries(void)
{
    __typeof__(&try_acquire) try = STUDENT(try_acquire);
    notes->tried[0] = attempt(try, lock);
    notes->tried[1] = attempt(try, lock);
    notes->tried[2] = attempt(try, lock + 1);
    STUDENT(release)(lock);
    notes->tried[3] = attempt(try, lock);
    notes->tried[4] = attempt(try, lock);
    STUDENT(release)(lock);
    STUDENT(acquire)(lock);
    notes->tried[5] = attempt(try, lock);
    STUDENT(release)(lock);
}

static void try_alone(void)
{
    static const bool right[] = {true, false, true, true, false, false};
    prepare(3);
    CALL(use_tries());
    if (notes->endless)
        WRONG(.expected = "an attempt that does not wait, and leaves "
                          "nothing behind",
              .found = "a thread that waits for ever",
              .cause = "An attempt that fails must not have drawn a "
                       "number: draw it only if it is the one that is "
                       "served now, in one atomic step.");
    for (int k = 0; k < 6; k++)
        if (notes->tried[k] != right[k])
            WRONG(.where = kit_text("attempt %d", k + 1),
                  .expected = right[k] ? "true: the lock is free"
                                       : "false: the lock is taken",
                  .found = notes->tried[k] ? "true" : "false",
                  .cause = "The lock is free if its two numbers are "
                           "equal, and taken if they are not.");
}

// ---- several -------------------------------------------------------

enum way { TAKE = 1, TRY = 2 }; // both: try, and take if it fails

static void work(enum way way, bool slow)
{
    enum { TURNS = 20 };
    __typeof__(&acquire) take = STUDENT(acquire);
    __typeof__(&release) give = STUDENT(release);
    __typeof__(&try_acquire) try = STUDENT(try_acquire);
    slow_motion(slow);
#pragma omp parallel num_threads(THREADS)
    for (int k = 0; k < TURNS; k++) {
        bool inside = way & TRY && attempt(try, lock);
        if (!inside && way & TAKE) {
            take(lock);
            inside = true;
        }
        if (inside) {
            stay_inside(20);
            give(lock);
        }
    }
}

static void keep_apart(uint32_t begin, enum way way, bool slow)
{
    prepare(begin);
    kit_given("%d threads, numbers from %u%s", THREADS, begin,
              slow ? ", in slow motion" : "");
    CALL(work(way, slow));
    refuse_company();
    kit_next_case();
}

static void tries(uint64_t seed)
{
    (void)seed;
    try_alone();
    kit_next_case();
    prepare(0);
    kit_given("attempts of %d threads, in slow motion", THREADS);
    CALL(work(TRY, true));
    if (notes->waited)
        WRONG(.where = "try_acquire, several threads",
              .expected = "an attempt that does not wait",
              .found = "a pause in an attempt",
              .cause = "Another thread came between the look and the "
                       "lock. An attempt that waits then was no "
                       "attempt: look and draw in one atomic step.");
    refuse_company();
}

static void exclusive(uint64_t seed)
{
    (void)seed;
    for (int slow = 0; slow < 2; slow++) {
        keep_apart(0, TAKE, slow);
        keep_apart(0, TAKE | TRY, slow);
    }
}

// The first thread holds the lock until all others have come, a few
// milliseconds apart.
static void queue_up(void)
{
    __typeof__(&acquire) take = STUDENT(acquire);
    __typeof__(&release) give = STUDENT(release);
    take(lock);
    notes->inside++;
#pragma omp parallel num_threads(THREADS)
    {
        int t = omp_get_thread_num();
        if (t == 0) {
            while (notes->arrived < THREADS - 1)
                sleep_us(1000);
            sleep_us(10000);
            notes->inside--;
            give(lock);
        } else {
            sleep_us(4000 * t);
            uint32_t turn = notes->arrived++;
            take(lock);
            notes->entry[notes->entered++] = turn;
            stay_inside(200);
            give(lock);
        }
    }
}

static bool in_order(void)
{
    for (uint32_t k = 0; k < THREADS - 1; k++)
        if (notes->entry[k] != k)
            return false;
    return true;
}

// In how many of so many trials, one for each beginning, threads got in
// as they had come. What one of the others found goes to *found.
static int fair_trials(int trials, uint32_t begin, const char **found)
{
    int fair = 0;
    for (int trial = 0; trial < trials; trial++) {
        prepare(begin - trial);
        kit_given("a lock that is taken, and %d threads that come one "
                  "after the other",
                  THREADS - 1);
        CALL(queue_up());
        refuse_company();
        fair += in_order();
        if (!in_order())
            *found = kit_text("%u, %u, %u, %u", notes->entry[0],
                              notes->entry[1], notes->entry[2],
                              notes->entry[3]);
    }
    return fair;
}

// A thread may lose the processor just before it comes: not every time.
static void refuse_unfair(void)
{
    enum { TRIALS = 5, ENOUGH = 3 };
    const char *found = "";
    if (fair_trials(TRIALS, TRIALS, &found) < ENOUGH)
        WRONG(.expected = "threads 0, 1, 2, 3, in the order of arrival",
              .found = found,
              .cause = "When the lock is given back, the thread that "
                       "looks first has it, however long the others "
                       "have waited. Each thread needs a number of its "
                       "own when it comes.");
    kit_next_case();
}

static void in_turn(uint64_t seed)
{
    (void)seed;
    keep_apart(0, TAKE, true);
    keep_apart(0, TAKE | TRY, true);
    refuse_unfair();
}

static void around(uint64_t seed)
{
    in_turn(seed); // or else the largest number is not the cause
    first_number = UINT32_MAX;
    kit_if_endless(cause(""));
    check_alone(UINT32_MAX - 2, 6);
    keep_apart(UINT32_MAX - 20, TAKE, true);
    keep_apart(UINT32_MAX - 20, TAKE | TRY, true);
    const char *found = "";
    if (fair_trials(3, UINT32_MAX, &found) < 2)
        WRONG(.expected = "threads in the order of arrival, beyond the "
                          "largest number, too",
              .found = found, .cause = cause(""));
}

const struct kit_test kit_tests[] = {
    {"alone", 1, "a single thread, a thousand times", alone},
    {"separate", 1, "two locks do not know each other", separate},
    {"tries", 1, "attempts that do not wait", tries},
    {"exclusive", 1, "one thread at a time", exclusive},
    {"in-turn", 4, "threads get in as they have come", in_turn},
    {"around", 2, "beyond the largest number", around},
    {0},
};
