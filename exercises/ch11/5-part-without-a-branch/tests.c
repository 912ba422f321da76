// Tests of the parting: what comes first and in which order, and its
// time beside that of a loop that counts and copies.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

static uint32_t n, *list, *room, *first;
static double *value, cut;

// Numbers of values, in a random order.
static void prepare(uint32_t count, double at, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = count;
    cut = at;
    value = kit_input("value", n, sizeof *value);
    list = kit_output("list", n, sizeof *list);
    room = kit_output("room", n, sizeof *room);
    first = kit_output("the answer", 1, sizeof *first);
    for (uint32_t k = 0; k < n; k++) {
        value[k] = (double)(random_bits(&random) % 1000) / 1000;
        list[k] = k;
    }
    for (uint32_t k = n - 1; k > 0; k--) {
        const uint32_t other = random_bits(&random) % (k + 1);
        const uint32_t swap = list[k];
        list[k] = list[other];
        list[other] = swap;
    }
    kit_given("%u numbers, cut at %g", n, cut);
}

static const char *cause_of(uint32_t found, bool less)
{
    if (found >= n)
        return "This is the number of no value: was room copied too "
               "far, or from too far?";
    if ((value[found] < cut) != less)
        return "It is on the wrong side: what is equal to the cut "
               "comes second.";
    return "It is on its side, but not in its place: the numbers of a "
           "side stay in their order.";
}

static void try_part(uint32_t count, double at, uint64_t seed)
{
    prepare(count, at, seed);
    uint32_t *right = malloc(n * sizeof *right), less = 0, k = 0;
    for (uint32_t s = 0; s < n; s++)
        less += value[list[s]] < cut;
    for (int side = 0; side < 2; side++)
        for (uint32_t s = 0; s < n; s++)
            if ((value[list[s]] < cut) != side)
                right[k++] = list[s];
    CALL(*first = STUDENT(part_list)(value, list, n, cut, room));
    if (*first != less)
        WRONG(.expected =
                  kit_text("%u numbers in the first part", less),
              .found = kit_text("%u", *first),
              .cause = "Count those whose value is less than the cut, "
                       "and no others.");
    for (uint32_t s = 0; s < n; s++)
        if (list[s] != right[s])
            WRONG(.where = kit_text("place %u of %u", s, n),
                  .expected = kit_text("%u", right[s]),
                  .found = kit_text("%u", list[s]),
                  .cause = cause_of(list[s], s < less));
    free(right);
}

static void halves(uint64_t seed)
{
    for (uint32_t k = 1; k < 60; k++)
        try_part(k, 0.5, seed + k);
    try_part(10000, 0.5, seed);
}

static void one_side(uint64_t seed)
{
    try_part(100, 2, seed);
    try_part(100, -1, seed);
    try_part(1, 2, seed);
    try_part(1, -1, seed);
}

static void seldom(uint64_t seed)
{
    try_part(1000, 0.01, seed);
    try_part(1000, 0.99, seed);
}

// ---- time ----------------------------------------------------------
enum { TIMED = 1 << 18, REPEATS = 25 };
static uint32_t *fresh;

// Reads and writes as much, and parts nothing: each number is copied
// aside, and the count makes each comparison.
static uint32_t count_and_copy(void)
{
    uint32_t less = 0, number;
    for (uint32_t k = 0; k < n; k++) {
        number = list[k];
        room[k] = number;
        less += value[number] < cut;
        __asm__ volatile("" ::: "memory"); // one by one
    }
    memcpy(list, room, n / 2 * sizeof *list);
    return less;
}

static void theirs(void)
{
    CALL(for (int r = 0; r < REPEATS; r++) {
        memcpy(list, fresh, TIMED * sizeof *list);
        *first = STUDENT(part_list)(value, list, n, cut, room);
    });
}

static void ours(void)
{
    CALL(for (int r = 0; r < REPEATS; r++) {
        memcpy(list, fresh, TIMED * sizeof *list);
        *first = count_and_copy();
    });
}

static void in_time(uint64_t seed)
{
    try_part(TIMED, 0.5, seed);
    prepare(TIMED, 0.5, seed);
    fresh = kit_input("a copy", TIMED, sizeof *fresh);
    for (uint32_t k = 0; k < TIMED; k++)
        fresh[k] = k; // in order, so that values come in a stream
    double ratio =
        kit_race((struct kit_race){theirs, ours, .cores = 1});
    kit_bands(ratio, (struct kit_band[]){{1.8, 6}, {2.5, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 1.8 times the time of counting "
                              "and copying",
                  .found = kit_text("%.1f times", ratio),
                  .cause = "Whether a value is less cannot be guessed. "
                           "Write every number, and let the comparison "
                           "move a counter."});
}

const struct kit_test kit_tests[] = {
    {"halves", 2, "half of them on either side, in order", halves},
    {"one-side", 1, "all of them on one side", one_side},
    {"seldom", 1, "nearly all of them on one side", seldom},
    {"time", 6, "nearly as fast as a loop without a branch", in_time},
    {0},
};
