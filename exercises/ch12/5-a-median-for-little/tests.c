// Tests of the rank: the answer, against the numbers themselves, and
// how often two were compared.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>

static uint32_t n, *value, *room, *found;
static uint64_t *asked;

bool is_less(uint32_t a, uint32_t b)
{
    ++*asked;
    return value[a] < value[b];
}

// The numbers 0 to n - 1 in a random order.
static void prepare(uint32_t count, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    n = count;
    value = kit_input("the numbers", n, sizeof *value);
    room = kit_output("room", 2 * (size_t)n, sizeof *room);
    found = kit_output("the answer", n, sizeof *found);
    asked = kit_output("the count", 1, sizeof *asked);
    for (uint32_t k = 0; k < n; k++)
        value[k] = k;
    for (uint32_t k = n - 1; k > 0; k--) {
        const uint32_t other = random_bits(&random) % (k + 1);
        const uint32_t swap = value[k];
        value[k] = value[other];
        value[other] = swap;
    }
}

static void give(uint32_t rank)
{
    kit_given("%u numbers, rank %u", n, rank);
}

static void check(uint32_t rank, uint32_t answer)
{
    give(rank);
    if (answer >= n)
        WRONG(.expected = kit_text("a number below %u", n),
              .found = kit_text("%u", answer),
              .cause = "Was the room read where nothing was written?");
    if (value[answer] != rank)
        WRONG(.expected = kit_text("the number of rank %u", rank),
              .found = kit_text("that of rank %u", value[answer]),
              .cause = labs((long)value[answer] - (long)rank) == 1
                           ? "It is next to it: ranks begin at 0, and "
                             "the pivot has one, too."
                           : "Were those counted that are below what "
                             "was kept?");
}

static void ask(uint32_t rank)
{
    give(rank);
    CALL(*asked = 0; *found = STUDENT(number_of_rank)(n, rank, room));
    check(rank, *found);
}

static void ask_for_all(void)
{
    CALL(for (uint32_t rank = 0; rank < n; rank++) {
        give(rank);
        found[rank] = STUDENT(number_of_rank)(n, rank, room);
        check(rank, found[rank]);
    });
    for (uint32_t rank = 0; rank < n; rank++)
        check(rank, found[rank]);
}

static void few(uint64_t seed)
{
    for (uint32_t count = 1; count < 40; count++) {
        prepare(count, seed + count);
        ask_for_all();
    }
}

static void many(uint64_t seed)
{
    for (int trial = 0; trial < 40; trial++) {
        prepare(3000, seed + trial);
        ask(trial < 3   ? (uint32_t)trial
            : trial < 6 ? 2999 - (uint32_t)trial
                        : 75 * (uint32_t)trial);
    }
}

// The mean of many sets, always the same ones. The chapter's method
// takes 2.44 n, and single sets stray by a tenth of n; without a sample
// it is 3.4 n, with medians of three 2.75 n, and single sets stray by
// 1.0 and 0.6 n, so their means by 0.1 and 0.06 n.
static void count(uint64_t seed)
{
    enum { SETS = 100 };
    double sum = 0;
    (void)seed;
    for (int set = 0; set < SETS; set++) {
        prepare(30000, 1 + set);
        ask(n / 2);
        sum += (double)*asked / n;
    }
    const double mean = sum / SETS;
    kit_given("%d sets of 30,000 numbers, the same for every seed",
              SETS);
    kit_bands(mean, (struct kit_band[]){{2.6, 6}, {6, 3}, {0, 0}},
              (struct kit_fault){
                  .expected = "at most 2.60 n questions on average",
                  .found = kit_text("%.2f n", mean),
                  .cause = "Two bounds from a sample leave little to "
                           "search."});
}

const struct kit_test kit_tests[] = {
    {"few", 2, "every rank of few numbers", few},
    {"many", 2, "ranks of 3,000 numbers, first and last too", many},
    {"count", 6, "few questions", count},
    {0},
};
