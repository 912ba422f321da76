// Tests of the contacts that are kept: the list, and how often the dear
// question was asked. The mesh is a lattice of squares, each of them
// cut in two; which others meet is random.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <stdlib.h>
#include <string.h>

enum { MOST = 40000 };

static uint32_t side, triangles, count, *kept;
static uint32_t (*corner)[3];
static uint64_t *asked, salt;
static struct pair *given, *pair;

static bool neighbors(uint32_t t, uint32_t u)
{
    for (int k = 0; k < 9; k++)
        if (corner[t][k % 3] == corner[u][k / 3])
            return true;
    return false;
}

// Neighbors touch, and one in three of the others.
static bool touch(uint32_t t, uint32_t u)
{
    struct random random = {salt + (uint64_t)t * triangles + u};
    return neighbors(t, u) || random_bits(&random) % 3 == 0;
}

bool triangles_meet(uint32_t t, uint32_t u)
{
    ++*asked;
    return touch(t, u);
}

static uint64_t key_of(const void *p)
{
    const struct pair *at = p;
    return (uint64_t)at->one << 32 | at->other;
}

static int compare(const void *one, const void *other)
{
    return (key_of(one) > key_of(other)) -
           (key_of(one) < key_of(other));
}

static void lay_mesh(struct random *random)
{
    for (uint32_t t = 0; t < triangles; t++) {
        const uint32_t x = t / 2 % side, y = t / 2 / side;
        const uint32_t node = y * (side + 1) + x;
        const uint32_t across[2] = {node, node + side + 2};
        const uint32_t third = t % 2 ? node + 1 : node + side + 1;
        const uint32_t turn = random_bits(random) % 3;
        corner[t][turn] = across[0];
        corner[t][(turn + 1) % 3] = across[1];
        corner[t][(turn + 2) % 3] = third;
    }
}

static void add(uint32_t t, uint32_t u, uint32_t copies)
{
    for (; copies > 0 && count < MOST; copies--)
        given[count++] = (struct pair){t, u};
}

static void prepare(uint32_t squares, uint32_t copies, uint64_t seed)
{
    struct random random = {seed};
    kit_next_case();
    side = squares;
    triangles = 2 * side * side;
    salt = random_bits(&random);
    corner = kit_input("corner", triangles, sizeof *corner);
    given = kit_input("the candidates", MOST, sizeof *given);
    pair = kit_output("pair", MOST, sizeof *pair);
    kept = kit_output("the answer", 1, sizeof *kept);
    asked = kit_output("the count", 1, sizeof *asked);
    lay_mesh(&random);
    count = 0;
    for (uint32_t t = 0; t < triangles; t++)
        for (uint32_t u = t + 1; u < triangles; u++)
            if (neighbors(t, u) || random_bits(&random) % triangles < 4)
                add(t, u, 1 + random_bits(&random) % copies);
    qsort(given, count, sizeof *given, compare);
    kit_given("%u candidates of %u triangles", count, triangles);
}

static bool same(struct pair a, struct pair b)
{
    return a.one == b.one && a.other == b.other;
}

static const char *text_of(const struct pair *p)
{
    return p ? kit_text("triangles %u and %u", p->one, p->other)
             : "no more";
}

static const char *cause_of(const struct pair *is,
                            const struct pair *was)
{
    if (!is)
        return "A contact is missing: these two share no node, and "
               "they meet.";
    if (is->one >= triangles || is->other >= triangles)
        return "There are no such triangles.";
    if (neighbors(is->one, is->other))
        return "They share a node. It need not be the same corner of "
               "both.";
    if (was && same(*is, *was))
        return "A pair comes several times, and is to be kept once.";
    if (!touch(is->one, is->other))
        return "These two do not meet.";
    return "Contacts stay in the order of the candidates, and none is "
           "left out.";
}

static void ask(void)
{
    CALL(*asked = 0; memcpy(pair, given, count * sizeof *pair);
         *kept = STUDENT(keep_contacts)(pair, count,
                                        (const uint32_t(*)[3])corner));
    uint32_t n = 0;
    for (uint32_t k = 0; k <= count; k++) {
        if (k < count && ((k > 0 && same(given[k], given[k - 1])) ||
                          neighbors(given[k].one, given[k].other) ||
                          !touch(given[k].one, given[k].other)))
            continue;
        const struct pair *right = k < count ? &given[k] : NULL;
        const struct pair *found =
            n < *kept && n < MOST ? &pair[n] : NULL;
        if (right ? !found || !same(*right, *found) : found != NULL)
            WRONG(.where = kit_text("contact %u", n),
                  .expected = text_of(right), .found = text_of(found),
                  .cause =
                      cause_of(found, n > 0 ? &pair[n - 1] : NULL));
        n++;
    }
}

static void few(uint64_t seed)
{
    for (uint32_t squares = 1; squares <= 6; squares++) {
        prepare(squares, 1, seed + squares);
        ask();
    }
}

static void copies(uint64_t seed)
{
    for (uint32_t trial = 0; trial < 5; trial++) {
        prepare(4 + 3 * trial, 3, seed + trial);
        ask();
    }
}

// How often one asks who compares with the last pair that was kept.
static double asked_if_last_kept(void)
{
    const struct pair *last = NULL;
    double questions = 0;
    for (uint32_t k = 0; k < count; k++) {
        if (neighbors(given[k].one, given[k].other) ||
            (last && same(given[k], *last)))
            continue;
        questions++;
        if (touch(given[k].one, given[k].other))
            last = &given[k];
    }
    return questions;
}

static void questions(uint64_t seed)
{
    prepare(20, 3, seed);
    ask();
    double least = 0, each = 0;
    for (uint32_t k = 0; k < count; k++)
        if (!neighbors(given[k].one, given[k].other)) {
            each++;
            least += k == 0 || !same(given[k], given[k - 1]);
        }
    const double is = (double)*asked;
    kit_bands(
        is, (struct kit_band[]){{least, 6}, {each, 3}, {0, 0}},
        (struct kit_fault){
            .expected = kit_text("%.0f questions", least),
            .found = kit_text("%.0f questions", is),
            .cause = is > each ? "Neighbors need no dear question: "
                                 "ask first what costs nothing."
                     : is == asked_if_last_kept()
                         ? "A pair was asked about again, though it "
                           "had been read before: it may not have "
                           "been kept."
                         : "A pair was asked about again, though it "
                           "had been read before: its copies stand "
                           "side by side."});
}

const struct kit_test kit_tests[] = {
    {"few", 2, "the contacts, if no pair comes twice", few},
    {"copies", 2, "the contacts, each once", copies},
    {"questions", 6, "no question that need not be asked", questions},
    {0},
};
