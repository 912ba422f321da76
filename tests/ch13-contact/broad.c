// Every broad phase finds the pairs of a loop over all pairs, in the
// same order.
#include "ch13-contact/broad_phase.h"
#include "ch13-contact/scenes.h"
#include "ch13-contact/step.h"
#include "common/random.h"
#include "parts.h"
#include <math.h>
#include <string.h>

enum { MOST = 300 };

// ---- boxes ---------------------------------------------------------
enum kind {
    EVEN,
    EQUAL,
    SIZES,
    FLAT,
    LINE,
    POINTS,
    SAME_LOW,
    LATTICE,
    KINDS
};

static double draw_width(enum kind kind, struct random *random)
{
    switch (kind) {
    case EQUAL:
        return 1;
    case SIZES: // giants and dwarfs
        return pow(2, -60 * random_uniform(random));
    case POINTS:
        return 0;
    case LATTICE: // many touch
        return random_bits(random) % 3;
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
            if (kind == LATTICE)
                low = floor(30 * low);
            boxes->low[k][t] = low;
            boxes->high[k][t] = low + draw_width(kind, random);
            if (kind == FLAT && k == 2)
                boxes->high[k][t] = low;
        }
}

// Boxes go some way, and some have a new width.
static void move_boxes(struct boxes *boxes, enum kind kind,
                       struct random *random)
{
    for (uint32_t t = 0; t < boxes->n; t++)
        for (int k = 0; k < 3; k++) {
            const double width = boxes->high[k][t] - boxes->low[k][t];
            const bool grows =
                kind != LATTICE && random_bits(random) % 64 == 0;
            double by = 0.05 * (random_uniform(random) - 0.5);
            if (kind == LATTICE)
                by = (double)(random_bits(random) % 3) - 1;
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
        group[t] = draw == 0 ? NO_INDEX : draw < 4 ? t / 7 : draw;
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
                group && group[i] == group[j] && group[i] != NO_INDEX;
            for (int k = 0; k < 3; k++)
                apart |= b->high[k][i] < b->low[k][j] ||
                         b->high[k][j] < b->low[k][i];
            count += !apart;
        }
    return count;
}

static void run_row(const struct broad_phase *row, uint32_t n,
                    enum kind kind, int threads)
{
    static uint32_t group[MOST];
    struct random random = {n + 100 * kind};
    struct boxes boxes = {0};
    struct pairs found = {0}, plain = {0};
    draw_boxes(&boxes, n, kind, &random);
    group_boxes(group, n, &random);
    void *kept = row->begin(row);
    for (int step = 0; step < 6; step++) {
        const uint32_t *groups = step < 3 ? group : NULL;
        const struct broad_search search = {&boxes, groups, &found,
                                            threads};
        find_pairs(row, kept, &search);
        const struct broad_search all = {&boxes, groups, &plain, 1};
        find_pairs(&broad_phases[0], NULL, &all);
        CHECK_INT(count_plainly(&boxes, groups), plain.count,
                  "all pairs of %u boxes, kind %d", n, kind);
        CHECK(same_pairs(&found, &plain),
              "%s, %u boxes, kind %d, step %d, %d threads", row->name,
              n, kind, step, threads);
        check_sorted(&found, n, row->name);
        move_boxes(&boxes, kind, &random);
    }
    row->end(kept);
    boxes_free(&boxes);
    pairs_free(&found);
    pairs_free(&plain);
}

void all_broad_phases(void)
{
    static const uint32_t sizes[] = {0, 1, 2, 3, 33, MOST};
    for (int row = 0; row < broad_phase_count; row++)
        for (int kind = 0; kind < KINDS; kind++)
            for (int size = 0; size < 6; size++)
                run_row(&broad_phases[row], sizes[size], kind,
                        size < 4 ? 1 : 1 << (size + kind) % 3);
}

// ---- scenes in motion ----------------------------------------------
void moving_scenes(void)
{
    static const char *const names[] = {"cloud", "giant", "cloth",
                                        "bullet", "pile"};
    for (int scene = 0; scene < 5; scene++)
        for (int row = 1; row < broad_phase_count; row++) {
            const struct built_in *kind = find_built_in(names[scene]);
            const uint32_t size = scene < 2 ? 12 : 8;
            struct simulation s = simulation_of(
                build_scene(kind, size, 3), &broad_phases[row],
                kind->dt, 1 + row % 3);
            struct pairs plain = {0};
            for (int step = 0; step < 5; step++) {
                take_step(&s);
                const struct broad_search all = {
                    &s.boxes, s.scene.group, &plain, 1};
                find_pairs(&broad_phases[0], NULL, &all);
                CHECK(same_pairs(&s.pairs, &plain), "%s, %s, step %d",
                      names[scene], broad_phases[row].name, step);
            }
            pairs_free(&plain);
            simulation_free(&s);
        }
}

// Runs of boxes, as many in each unit of space whatever their number.
static void draw_runs(struct boxes *boxes, uint32_t n)
{
    struct random random = {n};
    const double side = cbrt(n / 32.0);
    double middle[3] = {0};
    boxes_reserve(boxes, n);
    for (uint32_t t = 0; t < n; t++)
        for (int k = 0; k < 3; k++) {
            if (t % 32 == 0)
                middle[k] = side * random_uniform(&random);
            boxes->low[k][t] = middle[k] + random_uniform(&random);
            boxes->high[k][t] = boxes->low[k][t] + 0.2;
        }
}

// For each box a broad phase does as much work, and finds as many
// pairs, in a scene that is eight times as large.
void work_grows_linearly(void)
{
    static const char *const names[] = {"kd-tree-anew", "orthotree",
                                        "cells", "clusters"};
    for (int name = 0; name < 4; name++) {
        const struct broad_phase *phase = find_broad_phase(names[name]);
        double tested[2], found[2];
        for (int size = 0; size < 2; size++) {
            struct boxes boxes = {0};
            struct pairs pairs = {0};
            const uint32_t n = size ? 64000 : 8000;
            draw_runs(&boxes, n);
            void *kept = phase->begin(phase);
            const struct broad_search search = {&boxes, NULL, &pairs,
                                                2};
            find_pairs(phase, kept, &search);
            tested[size] = (double)pairs.tested / n;
            found[size] = (double)pairs.count / n;
            phase->end(kept);
            boxes_free(&boxes);
            pairs_free(&pairs);
        }
        CHECK(tested[1] < 1.2 * tested[0], "%s: %g, then %g",
              names[name], tested[0], tested[1]);
        CHECK(found[1] < 1.2 * found[0] && found[0] > 0.2,
              "%s: %g, then %g found", names[name], found[0], found[1]);
    }
}

// What a step of a cloud of side^3 bodies in motion counts, for each
// triangle.
static void count_step(uint32_t side, const char *broad,
                       double counts[3])
{
    struct scene scene = {0};
    fill_cloud(&scene, side * side * side, 1, 1);
    scene_complete(&scene);
    struct simulation s =
        simulation_of(scene, find_broad_phase(broad), 0.05, 1);
    const double n = s.scene.mesh.triangles;
    for (int step = 0; step < 7; step++) {
        const struct step_report report = take_step(&s);
        counts[0] = (double)report.tested / n;
        counts[1] = (double)report.candidates / n;
        counts[2] = (double)(report.paired - report.apart) / n;
    }
    simulation_free(&s);
}

// Bodies at the surface have fewer neighbors: a cloud of side 8 has 7/8
// of those of a cloud without end, a cloud of side 12 has 11/12.
void a_step_grows_linearly(void)
{
    double small[3], large[3], cells[3];
    count_step(8, "clusters", small);
    count_step(12, "clusters", large);
    count_step(8, "cells", cells);
    CHECK(large[0] < 1.2 * small[0], "looked at: %g, then %g", small[0],
          large[0]);
    CHECK(large[1] < 1.2 * small[1] && small[1] > 0.05,
          "candidates: %g, then %g", small[1], large[1]);
    CHECK(large[2] < 0.2 * large[1], "%g of %g are searched", large[2],
          large[1]);
    CHECK(small[0] < 0.25 * cells[0],
          "clusters look at %g, cells at %g", small[0], cells[0]);
}

void nothing_is_allocated(void)
{
    static const char *const names[] = {"sweep-kept", "clusters"};
    for (int name = 0; name < 2; name++) {
        const struct built_in *cloud = find_built_in("cloud");
        struct simulation s =
            simulation_of(build_scene(cloud, 27, 5),
                          find_broad_phase(names[name]), 1e-9, 1);
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
    for (int row = 0; row < broad_phase_count; row++)
        CHECK(find_broad_phase(broad_phases[row].name) ==
                  &broad_phases[row],
              "%s", broad_phases[row].name);
    CHECK(!find_broad_phase("none"), "none");
    for (int row = 0; row < built_in_count; row++)
        CHECK(find_built_in(built_ins[row].name) == &built_ins[row],
              "%s", built_ins[row].name);
    CHECK(!find_built_in("none"), "none");
}
