// Tests of the lock: one thread at a time, in slow motion, too; the
// order of arrival; attempts that do not wait; and numbers that begin
// near the end of their range.
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
    _Atomic bool endless;
    _Atomic uint32_t arrived, entered;
    uint32_t arrival[THREADS];
    uint32_t entry[THREADS]; // which of the arrivals came in
    bool tried[8];
    uint32_t numbers[2]; // next and serving, at the end
} * notes;
static struct lock *lock; // and a second one behind it

static void sleep_us(long us)
{
    nanosleep(&(struct timespec){.tv_nsec = us * 1000}, NULL);
}

void pause_before_next_look(void)
{
    if (notes->pauses++ >= PAUSES) {
        notes->endless = true;
        kit_leave();
    }
    sleep_us(20 + notes->pauses * 7919 % 16 * 20);
}

static void prepare(uint32_t begin)
{
    notes = kit_output("the notes", 1, sizeof *notes);
    *notes = (struct notes){.inside = 0};
    lock = kit_output("the locks", 2, sizeof *lock);
    for (int k = 0; k < 2; k++) {
        lock[k].next = begin;
        lock[k].serving = begin;
    }
    kit_given("a lock whose two numbers begin at %u", begin);
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

static void refuse_endless(const char *where)
{
    if (notes->endless)
        WRONG(.where = where, .expected = "an end of the waiting",
              .found = kit_text("%d pauses, and still waiting", PAUSES),
              .cause = "The number that this thread waits for is never "
                       "served. Does each release serve the next "
                       "number, and no other? Has a thread drawn a "
                       "number that it does not wait for, or two "
                       "the same, because it is not read and moved on "
                       "in a single atomic step?");
}

static void refuse_company(void)
{
    refuse_endless("several threads");
    if (notes->together > 1)
        WRONG(.expected = "one thread at a time",
              .found = kit_text("%u inside together", notes->together),
              .cause = "Between a look and a store, another thread may "
                       "look, too, and see the same. The number of a "
                       "thread must be read and moved on in a single "
                       "atomic step.");
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
              .cause = "What release leaves behind must be a lock that "
                       "is free.");
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
    notes->tried[0] = try(lock);
    notes->tried[1] = try(lock);
    notes->tried[2] = try(lock + 1);
    STUDENT(release)(lock);
    notes->tried[3] = try(lock);
    notes->tried[4] = try(lock);
    STUDENT(release)(lock);
    STUDENT(acquire)(lock);
    notes->tried[5] = try(lock);
    STUDENT(release)(lock);
}

static void tries(uint64_t seed)
{
    (void)seed;
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

static void work(int turns, bool slow, bool with_tries)
{
    __typeof__(&acquire) take = STUDENT(acquire);
    __typeof__(&release) give = STUDENT(release);
    __typeof__(&try_acquire) try = STUDENT(try_acquire);
    slow_motion(slow);
#pragma omp parallel num_threads(THREADS)
    for (int k = 0; k < turns; k++) {
        if (!with_tries || !try(lock))
            take(lock);
        stay_inside(20);
        give(lock);
    }
}

static void exclusive(uint64_t seed)
{
    (void)seed;
    for (int k = 0; k < 4; k++) {
        prepare(0);
        kit_given("%d threads%s", THREADS,
                  k % 2 ? ", in slow motion" : "");
        CALL(work(20, k % 2, k > 1));
        refuse_company();
        kit_next_case();
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

// A thread may lose the processor just before it comes: not every time.
static void in_turn(uint64_t seed)
{
    (void)seed;
    enum { TRIALS = 5, ENOUGH = 3 };
    int fair = 0;
    const char *found = "";
    for (int trial = 0; trial < TRIALS; trial++) {
        prepare(0);
        kit_given("a lock that is taken, and %d threads that come one "
                  "after the other",
                  THREADS - 1);
        CALL(queue_up());
        refuse_company();
        fair += in_order();
        if (!in_order())
            found = kit_text("%u, %u, %u, %u", notes->entry[0],
                             notes->entry[1], notes->entry[2],
                             notes->entry[3]);
    }
    if (fair < ENOUGH)
        WRONG(.expected = "threads 0, 1, 2, 3, in the order of arrival",
              .found = found,
              .cause = "When the lock is given back, the thread that "
                       "looks first has it, however long the others "
                       "have waited. Each thread needs a number of its "
                       "own when it comes.");
}

static void around(uint64_t seed)
{
    (void)seed;
    check_alone(UINT32_MAX - 2, 6);
    prepare(UINT32_MAX - 20);
    CALL(work(12, false, false));
    refuse_company();
    int fair = 0;
    for (int t = 0; t < 3; t++) {
        prepare(UINT32_MAX - t);
        CALL(queue_up());
        refuse_company();
        fair += in_order();
    }
    if (fair > 1)
        return;
    WRONG(.expected = "threads in the order of arrival, beyond the "
                      "largest number, too",
          .found = "another order",
          .cause = "After the largest number comes 0. Compare whether "
                   "numbers are equal, not which is smaller.");
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
