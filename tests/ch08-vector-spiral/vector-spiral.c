// The vectorized spiral search: every version of its loops gives the
// right answers, visits the same cells as the search of chapter 7 and
// compares one point more for each query, which is itself; and as many
// tasks are packed away as the empty cells say.
#include "algorithms.h"
#include "ch07-spiral/experiments/census.h"
#include "ch07-spiral/experiments/expected.h"
#include "ch08-vector-spiral/by_primitives.h"
#include "ch08-vector-spiral/spiral_kernels.h"
#include "ch08-vector-spiral/vector_spiral.h"
#include <stdio.h>
#include <stdlib.h>

#include "check_spiral.h"

// ---- the same answers ----------------------------------------------
static void kernels_by_primitives_agree(void)
{
    for (int isa = 0; isa < ISA_COUNT; isa++)
        if (isa_present(isa)) {
            const struct spiral_kernels *kernels =
                &spiral_by_primitives[isa];
            check_spiral(kernels, "primitives");
        }
}

static void fused_kernels_agree(void)
{
    for (int isa = 0; isa < ISA_COUNT; isa++)
        if (isa_present(isa)) {
            const struct spiral_kernels *kernels = spiral_kernels(isa);
            check_spiral(kernels, isa_names[isa]);
        }
}

// Squares that overflow are no nearer than no neighbor, but they are
// of a neighbor.
static void huge_and_tiny(void)
{
    static const double scales[] = {1e300, 1e-300, 1e160, 1e-160};
    for (int s = 0; s < 4; s++)
        for (int isa = 0; isa < ISA_COUNT; isa++) {
            if (!isa_present(isa))
                continue;
            struct points points =
                generate(find_distribution("uniform"), 100, s);
            for (uint32_t i = 0; i < points.n; i++) {
                points.x[i] *= scales[s];
                points.y[i] *= scales[s];
            }
            const struct spiral_kernels *fused = spiral_kernels(isa);
            const struct spiral_kernels *plain =
                &spiral_by_primitives[isa];
            test_seed(s);
            check_points(points, (struct space){STANDARD, 1, 1}, fused,
                         "scaled, fused");
            check_points(points, (struct space){STANDARD, 1, 1}, plain,
                         "scaled, by primitives");
            points_free(&points);
        }
}

// ---- counts --------------------------------------------------------
static struct tally tally_of(const struct question *question, double c,
                             const struct spiral_kernels *kernels,
                             uint32_t length)
{
    struct answers answers = answers_allocate(question->points.n);
    struct grid grid = grid_fit(question, c);
    struct cells cells = cells_sort(&grid, question->points);
    struct tally tally;
    struct strip_plan plan = {kernels, length, &tally};
    search_in_lockstep(question, &grid, &cells, &plan, &answers);
    cells_free(&cells);
    grid_free(&grid);
    answers_free(&answers);
    return tally;
}

static void check_tally(const struct question *question,
                        const struct spiral_kernels *kernels,
                        uint32_t length, const char *what)
{
    uint32_t n = question->points.n;
    struct census census = take_census(question, 1);
    struct tally tally = tally_of(question, 1, kernels, length);
    CHECK_INT(n, (long long)tally.tasks, "%s: tasks", what);
    CHECK_INT(llround(census.cells * n), (long long)tally.visited,
              "%s: cells", what);
    CHECK_INT(llround(census.distances * n) + n,
              (long long)tally.compared,
              "%s: distances, and one to itself for each", what);
    CHECK(tally.entered <= tally.visited &&
              tally.visited <= tally.tried,
          "%s: every loop has what the one before has left", what);
    CHECK(tally.compared <= tally.lanes &&
              tally.compared <= tally.lanes_unpacked,
          "%s: packing loses no task", what);
}

static void same_cells_as_the_spiral(void)
{
    static const char *const kinds[] = {"uniform", "clustered",
                                        "circle"};
    for (int kind = 0; kind < 3; kind++)
        for (int g = STANDARD; g <= WRAPAROUND; g++) {
            struct points points =
                generate(find_distribution(kinds[kind]), 5000, 1);
            for (uint32_t i = 0; i < points.n; i++)
                points.x[i] += 3, points.y[i] += 3;
            struct question question = {points, {g, 9, 9}, 1 + g};
            test_seed(1);
            for (int isa = 0; isa < ISA_COUNT; isa++) {
                if (!isa_present(isa))
                    continue;
                const struct spiral_kernels *fused =
                    spiral_kernels(isa);
                const struct spiral_kernels *plain =
                    &spiral_by_primitives[isa];
                check_tally(&question, fused, 64, kinds[kind]);
                check_tally(&question, plain, 4096, kinds[kind]);
            }
            points_free(&points);
        }
}

static void counted_by_the_table(void)
{
    struct points points =
        generate(find_distribution("uniform"), 3000, 2);
    struct question question = {points, {STANDARD, 1, 1}, 2};
    struct answers answers = answers_allocate(3000);
    struct counts one =
        count_operations(find_algorithm("spiral"), &question, &answers);
    struct counts all = count_operations(
        find_algorithm("vector-spiral"), &question, &answers);
    CHECK_INT((long long)one.distances + 3000, (long long)all.distances,
              "distances");
    CHECK_INT((long long)one.cells, (long long)all.cells, "cells");
    CHECK_INT(3000, (long long)all.tasks, "tasks");
    answers_free(&answers);
    points_free(&points);
}

// Phase one gets to a layer if all cells before are empty: 1, 9, 25 of
// them. Without a border it holds for all points. The tolerance is some
// five standard deviations; that neighbors share empty cells doubles
// them.
static void packed_as_expected(void)
{
    static const double densities[] = {0.3, 0.5, 1};
    const uint32_t n = 200000;
    struct points points = generate(find_distribution("uniform"), n, 3);
    struct question question = {points, {WRAPAROUND, 1, 1}, 2};
    const struct spiral_kernels *kernels = spiral_kernels(isa_chosen());
    test_seed(3);
    for (int d = 0; d < 3; d++) {
        struct tally tally =
            tally_of(&question, densities[d], kernels, 512);
        double c = take_census(&question, densities[d]).per_cell;
        CHECK_INT(n, (long long)tally.phase_one[0], "in the own cell");
        for (int k = 1; k <= 3; k++) {
            double p = exp(-c * (2 * k - 1) * (2 * k - 1));
            CHECK_NEAR(
                p, tally.phase_one[k] / (double)n,
                10 * sqrt(p / n) + 1e-9,
                "c %g: share of the tasks in phase one at layer %d", c,
                k);
        }
        for (int k = 1; k <= 3; k++) {
            double cells = 0;
            for (int dx = -k; dx <= k; dx++)
                for (int dy = -k; dy <= k; dy++)
                    if (abs(dx) == k || abs(dy) == k)
                        cells += expected_visits(c, dx, dy);
            CHECK_NEAR(cells, tally.of_layer[k] / (double)n,
                       0.01 * cells + 10 * k * sqrt(cells / n) + 1e-9,
                       "c %g: cells visited in layer %d", c, k);
        }
    }
    points_free(&points);
}

int main(void)
{
    return RUN_TESTS(
        "ch08-vector-spiral", TEST(kernels_by_primitives_agree),
        TEST(fused_kernels_agree), TEST(huge_and_tiny),
        TEST(same_cells_as_the_spiral), TEST(counted_by_the_table),
        TEST(packed_as_expected));
}
