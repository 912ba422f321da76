// Tests of the order that is repaired, and how many questions that
// took. Where a box begins is its rank, shuffled in several ways.
#include "common/random.h"
#include "exercise.h"
#include "kit.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static uint32_t n, *rank, *before, *order, *room;
static uint64_t *asked;

bool begins_before(uint32_t a, uint32_t b)
{
    if (a >= n || b >= n)
        abort();
    ++*asked;
    return rank[a] < rank[b];
}

static void begin_case(uint32_t boxes)
{
    kit_next_case();
    n = boxes;
    rank = kit_input("where boxes begin", n, sizeof *rank);
    before = kit_input("the order before", n, sizeof *before);
    order = kit_output("order", n, sizeof *order);
    room = kit_output("room", n, sizeof *room);
    asked = kit_output("the count", 1, sizeof *asked);
    for (uint32_t i = 0; i < n; i++)
        before[i] = i;
    kit_given("%u boxes", n);
}

static void shuffle(uint32_t *list, uint32_t count,
                    struct random *random)
{
    for (uint32_t k = count; k > 1; k--) {
        const uint32_t other = random_bits(random) % k;
        const uint32_t swap = list[k - 1];
        list[k - 1] = list[other];
        list[other] = swap;
    }
}

// The box at a place of the list goes to another place.
static void jump(uint32_t *list, uint32_t from, uint32_t to)
{
    const uint32_t box = list[from];
    if (to > from)
        memmove(list + from, list + from + 1,
                (to - from) * sizeof *list);
    else
        memmove(list + to + 1, list + to, (from - to) * sizeof *list);
    list[to] = box;
}

// The list in rank[] says who begins first, second, ...; it becomes the
// ranks. Names of boxes are shuffled, so that they tell nothing.
static void name_boxes(struct random *random)
{
    uint32_t *name = calloc(n + 1, sizeof *name);
    uint32_t *list = calloc(n + 1, sizeof *list);
    for (uint32_t i = 0; i < n; i++) {
        name[i] = i;
        list[i] = rank[i];
    }
    shuffle(name, n, random);
    for (uint32_t i = 0; i < n; i++) {
        before[i] = name[i];
        rank[name[list[i]]] = i;
    }
    free(name);
    free(list);
}

enum way { UP = 1, DOWN = 2, ANY = 3 };

static void prepare(uint32_t boxes, uint32_t jumpers, enum way way,
                    uint64_t seed)
{
    struct random random = {seed};
    begin_case(boxes);
    for (uint32_t i = 0; i < n; i++)
        rank[i] = i;
    for (uint32_t k = 0; k < jumpers && n > 0; k++) {
        const uint32_t a = random_bits(&random) % n;
        const uint32_t b = random_bits(&random) % n;
        const bool swap = way == UP ? a > b : way == DOWN && a < b;
        jump(rank, swap ? b : a, swap ? a : b);
    }
    name_boxes(&random);
}

static void check_that_all_are_there(void)
{
    bool *seen = calloc(n + 1, sizeof *seen);
    uint32_t twice = n, lost = n;
    for (uint32_t r = 0; r < n; r++) {
        const uint32_t box = order[r] < n ? order[r] : n;
        if (seen[box] || box == n)
            twice = order[r];
        seen[box] = true;
    }
    for (uint32_t i = 0; i < n; i++)
        lost = seen[i] ? lost : i;
    free(seen);
    if (lost < n)
        WRONG(.expected = "each box once",
              .found = kit_text("box %u twice, or none, and not box %u",
                                twice, lost),
              .cause = "Something was written over before it was read, "
                       "or one of the lists was not taken to its end.");
}

static void ask(void)
{
    CALL(*asked = 0; memcpy(order, before, n * sizeof *order);
         STUDENT(repair)(n, order, room));
    check_that_all_are_there();
    for (uint32_t r = 1; r < n; r++)
        if (rank[order[r]] < rank[order[r - 1]])
            WRONG(.where = kit_text("places %u and %u", r - 1, r),
                  .expected = "the one that begins first",
                  .found = "the other one first",
                  .cause =
                      "These two are out of order. Were both lists "
                      "in order before they were merged?");
}

static void few(uint64_t seed)
{
    for (uint32_t boxes = 0; boxes < 400; boxes = 3 * boxes / 2 + 1)
        for (enum way way = UP; way <= ANY; way++) {
            prepare(boxes, boxes / 10 + 1, way, seed + boxes);
            ask();
        }
}

static void all(uint64_t seed)
{
    struct random random = {seed};
    for (uint32_t boxes = 2; boxes < 400; boxes = 3 * boxes / 2) {
        begin_case(boxes);
        for (uint32_t i = 0; i < n; i++)
            rank[i] = n - 1 - i;
        if (boxes % 2)
            shuffle(rank, n, &random);
        name_boxes(&random);
        ask();
    }
}

static void questions(uint64_t seed)
{
    double worst = 0;
    for (enum way way = UP; way <= ANY; way++)
        for (uint32_t jumpers = 20; jumpers <= 200; jumpers *= 10) {
            prepare(20000, jumpers, way, seed + jumpers);
            ask();
            const double most =
                2.0 * n + 3 * jumpers * log2(2 * jumpers);
            worst = fmax(worst, (double)*asked / most);
        }
    kit_bands(
        worst, (struct kit_band[]){{1, 6}, {2, 3}, {0, 0}},
        (struct kit_fault){
            .expected = "at most 2 n + 3 m log 2 m questions",
            .found = kit_text("%.1f times as many", worst),
            .cause = worst > 2
                         ? "Most boxes have kept their order. Of "
                           "two that are out of order, either may "
                           "have jumped."
                         : "What was taken out is little, but not "
                           "so little that any sort will do."});
}

const struct kit_test kit_tests[] = {
    {"few", 2, "the right order, where a few have jumped", few},
    {"all", 2, "the right order, where all have", all},
    {"questions", 6, "questions in proportion to the disorder",
     questions},
    {0},
};
