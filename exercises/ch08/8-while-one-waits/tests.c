// Tests of the walks: where the tasks arrive, and the time, beside that
// of walks one after the other.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <string.h>

static uint32_t tasks, places;
static uint32_t *begin, *steps, *next, *place;

// A way through all places, in no order that a processor could guess:
// the one cycle of a random permutation (Sattolo 1986).
static void lay(uint32_t count, struct random *random)
{
    places = count;
    next = kit_input("next", places, sizeof *next);
    for (uint32_t p = 0; p < places; p++)
        next[p] = p;
    for (uint32_t p = places - 1; p > 0; p--) {
        const uint32_t other = random_bits(random) % p;
        const uint32_t swap = next[p];
        next[p] = next[other];
        next[other] = swap;
    }
}

static void prepare(uint32_t count, uint32_t fewest, uint32_t most,
                    struct random *random)
{
    tasks = count;
    begin = kit_input("the beginning", tasks, sizeof *begin);
    steps = kit_input("steps", tasks, sizeof *steps);
    place = kit_output("place", tasks, sizeof *place);
    for (uint32_t t = 0; t < tasks; t++) {
        begin[t] = random_bits(random) % places;
        steps[t] = fewest + random_bits(random) % (most - fewest + 1);
    }
    memcpy(place, begin, tasks * sizeof *place);
    kit_given("%u tasks of %u to %u steps, through %u places", tasks,
              fewest, most, places);
}

// ---- answers -------------------------------------------------------

static uint32_t arrival(uint32_t t, uint32_t count)
{
    uint32_t p = begin[t];
    while (count-- > 0)
        p = next[p];
    return p;
}

static const char *cause(uint32_t t)
{
    if (steps[t] == 0)
        return "A task without a step stays where it is.";
    if (place[t] == begin[t])
        return "It has not moved. Are all tasks in some strip, also "
               "where the last strip is not full?";
    if (place[t] == arrival(t, steps[t] - 1))
        return "It is one step short. A task is packed away after its "
               "last step, not before it.";
    for (uint32_t more = 1; more <= 200; more++)
        if (place[t] == arrival(t, steps[t] + more))
            return "It has gone on after its last step: a task that "
                   "has arrived must leave the lanes.";
    for (uint32_t other = 0; other < tasks; other++)
        if (other != t && place[t] == arrival(other, steps[other]))
            return kit_text("Task %u arrives there. When lanes are "
                            "packed, a task, its place and the steps "
                            "that it has left stay together.",
                            other);
    return "Follow two tasks, of one step and of three, through your "
           "loop on paper.";
}

static void check(void)
{
    CALL(STUDENT(walk)(tasks, place, steps, next));
    for (uint32_t t = 0; t < tasks; t++) {
        const uint32_t right = arrival(t, steps[t]);
        if (place[t] != right)
            WRONG(.where = kit_text("task %u, from place %u, %u steps",
                                    t, begin[t], steps[t]),
                  .expected = kit_text("place %u", right),
                  .found = kit_text("place %u", place[t]),
                  .cause = cause(t));
    }
    kit_next_case();
}

static void few(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t count = 0; count <= 20; count++) {
        lay(20000, &random);
        prepare(count, 0, count % 5, &random);
        check();
    }
}

static void equal(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t length = 0; length <= 50; length += 5) {
        lay(20000, &random);
        prepare(300, length, length, &random);
        check();
    }
}

static void any(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t count = 100; count <= 1000; count += 90) {
        lay(20000, &random);
        prepare(count, 0, 200, &random);
        check();
    }
}

// ---- time ----------------------------------------------------------

static void theirs(void)
{
    CALL(memcpy(place, begin, tasks * sizeof *place);
         STUDENT(walk)(tasks, place, steps, next));
}

static void one_after_the_other(void)
{
    CALL(for (uint32_t t = 0; t < tasks; t++) {
        uint32_t p = begin[t], count = steps[t];
        for (; count > 0; count--)
            p = next[p];
        place[t] = p;
    });
}

// 16 MB of places: no cache that is near holds them.
static void in_time(uint64_t seed)
{
    any(seed);
    struct random random = {seed};
    lay(kit_is_sanitized() ? 1 << 12 : 1 << 22, &random);
    prepare(8000, 100, 300, &random);
    double ratio = kit_race(
        (struct kit_race){theirs, one_after_the_other, .cores = 1});
    kit_bands(
        ratio,
        (struct kit_band[]){{0.5, 6}, {0.67, 4}, {0.83, 2}, {0, 0}},
        (struct kit_fault){
            .expected = "half of the time of walks one after the other",
            .found = kit_text("%.2f of it", ratio),
            .cause = "A step waits for memory, and so does the next "
                     "one of the same task. The steps of other tasks "
                     "need not wait for it."});
}

const struct kit_test kit_tests[] = {
    {"few", 1, "a few tasks, or none", few},
    {"equal", 1, "tasks of equally many steps", equal},
    {"any", 2, "tasks of 0 to 200 steps", any},
    {"time", 6, "twice as fast as one after the other", in_time},
    {0},
};
