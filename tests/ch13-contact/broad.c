// Every broad phase finds the pairs of a loop over all pairs, in the
// same order.
#include "ch13-contact/broad.h"
#include "ch13-contact/scenes.h"
#include "ch13-contact/step.h"
#include "common/random.h"
#include "parts.h"
#include <math.h>
#include <string.h>

enum { MOST = 400 };

// ---- boxes ---------------------------------------------------------
enum kind { EVEN, EQUAL, SIZES, FLAT, LINE, POINTS, SAME_LOW, KINDS };

static double draw_width(enum kind kind, struct random *random)
{
    switch (kind) {
    case EQUAL:
        return 1;
    case SIZES: // giants and dwarfs
        return pow(2, -60 * random_uniform(random));
    case POINTS:
        return 0;
    default:
        return 0.2 * random_uniform(random);
    }
}

static void draw_boxes(struct boxes *boxes, uint32_t n, enum kind kind,
                       struct random *random)
{
    boxes_reserve(boxes, n);
    for (uint32_t t = 0; t < n; t++)
        for (int k = 0; k < 3; k++) {
            double low = random_uniform(random);
            if (kind == EQUAL || (kind == FLAT && k == 2) ||
                (kind == LINE && k > 0))
                low = 0.5;
            if (kind == POINTS || kind == SAME_LOW)
                low = floor(4 * low) / 4;
            boxes->low[k][t] = low;
            boxes->high[k][t] = low + draw_width(kind, random);
            if (kind == FLAT && k == 2)
                boxes->high[k][t] = low;
        }
}

// Boxes go some way, and some have a new width.
static void move_boxes(struct boxes *boxes, struct random *random)
{
    for (uint32_t t = 0; t < boxes->n; t++)
        for (int k = 0; k < 3; k++) {
            const double by = 0.05 * (random_uniform(random) - 0.5);
            const double width = boxes->high[k][t] - boxes->low[k][t];
            const bool grows = random_bits(random) % 64 == 0;
            boxes->low[k][t] += by;
            boxes->high[k][t] =
                boxes->low[k][t] + (grows ? 3 * width + 0.01 : width);
        }
}

static void group_boxes(uint32_t *group, uint32_t n,
                        struct random *random)
{
    for (uint32_t t = 0; t < n; t++) {
        const uint32_t draw = random_bits(random) % 8;
        group[t] = draw == 0 ? UINT32_MAX : draw < 4 ? t / 7 : draw;
    }
}

static bool same_pairs(const struct pairs *a, const struct pairs *b)
{
    return a->count == b->count &&
           (a->count == 0 ||
            memcmp(a->pair, b->pair, a->count * sizeof *a->pair) == 0);
}

static void check_sorted(const struct pairs *pairs, uint32_t n,
                         const char *name)
{
    for (uint32_t t = 0; t < n; t++)
        for (uint64_t p = pairs->start[t]; p < pairs->start[t + 1]; p++)
            if (!CHECK(pairs->pair[p].one == t &&
                           pairs->pair[p].other > t &&
                           (p == pairs->start[t] ||
                            pairs->pair[p - 1].other <
                                pairs->pair[p].other),
                       "%s: pair %u of triangle %u", name, (unsigned)p,
                       t))
                return;
}

// A loop that shares nothing with the broad phases.
static uint64_t count_plainly(const struct boxes *b,
                              const uint32_t *group)
{
    uint64_t count = 0;
    for (uint32_t i = 0; i < b->n; i++)
        for (uint32_t j = 0; j < i; j++) {
            bool apart =
                group && group[i] == group[j] && group[i] != UINT32_MAX;
            for (int k = 0; k < 3; k++)
                apart |= b->high[k][i] < b->low[k][j] ||
                         b->high[k][j] < b->low[k][i];
            count += !apart;
        }
    return count;
}

static void run_row(const struct broad *row, uint32_t n, enum kind kind,
                    int threads)
{
    static uint32_t group[MOST];
    struct random random = {n + 100 * kind};
    struct boxes boxes = {0};
    struct pairs found = {0}, plain = {0};
    draw_boxes(&boxes, n, kind, &random);
    group_boxes(group, n, &random);
    void *kept = row->begin(row);
    for (int step = 0; step < 4; step++) {
        const uint32_t *groups = step % 2 ? group : NULL;
        const struct broad_search search = {&boxes, groups, &found,
                                            threads};
        find_pairs(row, kept, &search);
        const struct broad_search all = {&boxes, groups, &plain, 1};
        find_pairs(&broads[0], NULL, &all);
        CHECK_INT(count_plainly(&boxes, groups), plain.count,
                  "all pairs of %u boxes, kind %d", n, kind);
        CHECK(same_pairs(&found, &plain),
              "%s, %u boxes, kind %d, step %d, %d threads", row->name,
              n, kind, step, threads);
        check_sorted(&found, n, row->name);
        move_boxes(&boxes, &random);
    }
    row->end(kept);
    boxes_free(&boxes);
    pairs_free(&found);
    pairs_free(&plain);
}

void all_broad_phases(void)
{
    static const uint32_t sizes[] = {0, 1, 2, 3, 33, MOST};
    for (int row = 0; row < broad_count; row++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int size = 0; size < 6; size++)
                run_row(&broads[row], sizes[size], kind,
                        1 << (size + kind) % 3);
}

// ---- scenes in motion ----------------------------------------------
void moving_scenes(void)
{
    static const char *const names[] = {"cloud", "giant", "cloth",
                                        "bullet", "pile"};
    for (int scene = 0; scene < 5; scene++)
        for (int row = 1; row < broad_count; row++) {
            const struct built_in *kind = find_built_in(names[scene]);
            const uint32_t size = scene < 2 ? 12 : 8;
            struct simulation s =
                simulation_of(build_scene(kind, size, 3), &broads[row],
                              kind->dt, 1 + row % 3);
            struct pairs plain = {0};
            for (int step = 0; step < 5; step++) {
                take_step(&s);
                const struct broad_search all = {
                    &s.boxes, s.scene.group, &plain, 1};
                find_pairs(&broads[0], NULL, &all);
                CHECK(same_pairs(&s.pairs, &plain), "%s, %s, step %d",
                      names[scene], broads[row].name, step);
            }
            pairs_free(&plain);
            simulation_free(&s);
        }
}

// For each triangle a broad phase does as much work in a scene that is
// eight times as large.
void work_grows_linearly(void)
{
    static const char *const names[] = {"kd-tree-anew", "cells",
                                        "clusters"};
    for (int name = 0; name < 3; name++) {
        double each[2], candidates[2];
        for (int size = 0; size < 2; size++) {
            const struct built_in *cloud = find_built_in("cloud");
            struct simulation s =
                simulation_of(build_scene(cloud, size ? 2744 : 343, 5),
                              find_broad(names[name]), 0.4, 2);
            s.passive = true;
            const struct step_report report = take_step(&s);
            const double n = s.scene.mesh.triangles;
            each[size] = (double)report.tested / n;
            candidates[size] = (double)report.candidates / n;
            simulation_free(&s);
        }
        // Bodies at the border of the cloud have fewer neighbors.
        CHECK(each[1] < 1.2 * each[0], "%s: %g tests a triangle, %g",
              names[name], each[0], each[1]);
        CHECK(candidates[1] < 1.2 * candidates[0],
              "%g candidates a triangle, %g", candidates[0],
              candidates[1]);
    }
}

void nothing_is_allocated(void)
{
    static const char *const names[] = {"sweep-kept", "clusters"};
    for (int name = 0; name < 2; name++) {
        const struct built_in *cloud = find_built_in("cloud");
        struct simulation s =
            simulation_of(build_scene(cloud, 27, 5),
                          find_broad(names[name]), 1e-9, 1);
        take_step(&s);
        const struct boxes boxes = s.boxes;
        const struct pairs pairs = s.pairs;
        const struct pair_list list = s.pairs.list[0];
        take_step(&s);
        CHECK(boxes.low[0] == s.boxes.low[0], "the boxes stay");
        CHECK(pairs.pair == s.pairs.pair &&
                  pairs.start == s.pairs.start &&
                  list.pair == s.pairs.list[0].pair,
              "the pairs stay");
        simulation_free(&s);
    }
}

void tables_are_searched(void)
{
    for (int row = 0; row < broad_count; row++)
        CHECK(find_broad(broads[row].name) == &broads[row], "%s",
              broads[row].name);
    CHECK(!find_broad("none"), "none");
    for (int row = 0; row < built_in_count; row++)
        CHECK(find_built_in(built_ins[row].name) == &built_ins[row],
              "%s", built_ins[row].name);
    CHECK(!find_built_in("none"), "none");
}
