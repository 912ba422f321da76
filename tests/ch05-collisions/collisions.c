// Collisions: every sort of the chapter against that of chapter 4, for
// every length of a group and every number of threads, on all kinds of
// points; and how many collide.
#include "algorithms.h"
#include "ch05-collisions/check_conflict.h"
#include "ch05-collisions/conflict.h"
#include "ch05-collisions/groups.h"
#include "ch05-collisions/partition.h"
#include "ch05-collisions/shared.h"
#include "common/fail.h"
#include "common/generate.h"
#include "common/isa.h"
#include <stdio.h>
#include <stdlib.h>

// ---- the same cells ------------------------------------------------
// Reports the first difference only: the others would say no more.
static bool same_numbers(const uint32_t *right, const uint32_t *found,
                         uint32_t count, const char *array,
                         const char *what)
{
    uint32_t k = 0;
    while (k < count && right[k] == found[k])
        k++;
    return k == count ||
           CHECK_INT(right[k], found[k], "%s: %s[%u]", what, array, k);
}

// Releases found.
static void check_cells(const struct cells *right, struct cells found,
                        uint32_t m, uint32_t n, const char *what)
{
    if (same_numbers(right->start, found.start, m + 1, "start", what))
        same_numbers(right->point, found.point, n, "point", what);
    cells_free(&found);
}

static const uint32_t group_lanes[] = {1, 2, 7, 8, 64, 1000, 100000};
static const int thread_counts[] = {1, 2, 3, 4, 7, 64};
enum { LANES = 7, THREADS = 6 };
enum { MOST_COUNTS = 1000000 }; // of 64 threads' private ones, say

// The same points in the same cells, in whatever order.
static void check_atomic(const struct grid *grid, struct points points,
                         const struct cells *right, int threads,
                         const char *what)
{
    const uint32_t m = grid_cells(grid), n = points.n;
    struct cells found = cells_sort_atomic(grid, points, threads);
    uint32_t *times = allocate(n, sizeof *times);
    memset(times, 0, n * sizeof *times);
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    find_cell_ids(grid, points, 0, n, cell_id);
    if (same_numbers(right->start, found.start, m + 1, "start", what))
        for (uint32_t k = 0; k < m; k++)
            for (uint32_t s = found.start[k]; s < found.start[k + 1];
                 s++) {
                uint32_t i = found.point[s];
                if (i >= n || cell_id[i] != k)
                    CHECK(false, "%s: point[%u] is at cell_id", what,
                          s);
                times[i % n]++;
            }
    for (uint32_t i = 0; i < n; i++)
        if (times[i] != 1)
            CHECK_INT(1, times[i], "%s: how often point %u is there",
                      what, i);
    free(times);
    free(cell_id);
    cells_free(&found);
}

// The same cells, and the points themselves in this order. Whatever
// stands at a place came there in the record into which it went.
static void check_partition(const struct grid *grid,
                            struct points points,
                            const struct cells *right, int threads,
                            const char *what)
{
    const uint32_t m = grid_cells(grid), n = points.n;
    static struct workspace workspace; // dirty from the last one
    for (int restore = NO_RESTORE; restore <= RESTORE; restore++) {
        struct mark mark = workspace_mark(&workspace);
        struct partition found = partition_points(grid, points, threads,
                                                  restore, &workspace);
        const struct sorted *sorted = &found.sorted;
        const uint32_t *point = sorted->cells.point;
        CHECK_INT(n, sorted->points.n, "%s: points", what);
        CHECK(grid->x.border == sorted->grid.x.border, "%s: grid",
              what);
        if (same_numbers(right->start, sorted->cells.start, m + 1,
                         "start", what) &&
            same_numbers(right->point, point, n, "point", what))
            for (uint32_t s = 0; s < n; s++) {
                CHECK_DOUBLE(points.x[point[s]], sorted->points.x[s],
                             "%s: x of place %u", what, s);
                CHECK_DOUBLE(points.y[point[s]], sorted->points.y[s],
                             "%s: y of place %u", what, s);
                if (restore)
                    CHECK_INT(found.permutation[point[s]],
                              found.inverse[s],
                              "%s: record to place %u", what, s);
            }
        CHECK(restore || (!found.permutation && !found.inverse),
              "%s: nothing to restore", what);
        workspace_release(&workspace, mark);
    }
}

// From the fitted grid to the answers' order, all in one block.
static void partition_fits(void)
{
    struct points points =
        generate(find_distribution("kuzmin"), 30000, 1);
    struct question question = {points, {STANDARD, 1, 1}, 2};
    struct workspace workspace = {0};
    for (int round = 0; round < 3; round++) {
        struct grid right = grid_fit(&question, 1.5);
        struct partition found =
            partition_make(&question, 1.5, RESTORE, &workspace);
        struct cells cells = cells_sort(&right, points);
        same_numbers(cells.start, found.sorted.cells.start,
                     grid_cells(&right) + 1, "start", "fitted");
        same_numbers(cells.point, found.sorted.cells.point, points.n,
                     "point", "fitted");
        cells_free(&cells);
        grid_free(&right);
        workspace_release(&workspace, (struct mark){0, 0});
    }
    CHECK(workspace.block[2].memory == NULL,
          "the borders have a block, and all the rest");
    workspace_free(&workspace);
    points_free(&points);
}

static void check_one_thread(const struct grid *grid,
                             struct points points,
                             const struct cells *right,
                             const char *name)
{
    const uint32_t m = grid_cells(grid), n = points.n;
    char what[120];
    for (int k = 0; k < LANES; k++) {
        snprintf(what, sizeof what, "%u %s points, groups of %u", n,
                 name, group_lanes[k]);
        check_cells(
            right,
            cells_sort_groups(grid, points, group_lanes[k], NULL), m, n,
            what);
    }
    snprintf(what, sizeof what, "%u %s points, conflicts", n, name);
    check_cells(right, cells_sort_conflict(grid, points), m, n, what);
}

static void check_threads(const struct grid *grid, struct points points,
                          const struct cells *right, int threads,
                          const char *name)
{
    const uint32_t m = grid_cells(grid), n = points.n;
    char what[120];
    snprintf(what, sizeof what, "%u %s points, %d threads, private", n,
             name, threads);
    if ((uint64_t)m * threads < MOST_COUNTS)
        check_cells(right, cells_sort_private(grid, points, threads), m,
                    n, what);
    snprintf(what, sizeof what, "%u %s points, %d threads, partition",
             n, name, threads);
    check_partition(grid, points, right, threads, what);
    snprintf(what, sizeof what, "%u %s points, %d threads, atomic", n,
             name, threads);
    check_atomic(grid, points, right, threads, what);
}

// Of one thread, or of those of the k-th number.
static void check_sorts(const char *name, struct points points,
                        double c, int k)
{
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, c);
    struct cells right = cells_sort(&grid, points);
    if (k == 0)
        check_one_thread(&grid, points, &right, name);
    check_threads(&grid, points, &right, thread_counts[k], name);
    cells_free(&right);
    grid_free(&grid);
}

static void check_generators(uint32_t n, double c, int k)
{
    // Far more threads than processors take long: some kinds only.
    const int step = thread_counts[k] > 7 ? 3 : 1;
    for (int d = 0; d < distribution_count; d += step) {
        test_seed(n);
        struct points points = generate(&distributions[d], n, n);
        check_sorts(distributions[d].name, points, c, k);
        points_free(&points);
    }
}

// Another number of threads means new threads: not at each length.
static void same_cells_of_every_length(void)
{
    for (int k = 0; k < THREADS; k++)
        for (uint32_t n = 1; n <= 300; n += n < 20 ? 1 : 31)
            check_generators(n, 2, k);
}

// So many cells that there are several buckets of the full width; few
// crowded cells; and more cells than points.
static void same_cells_of_many_points(void)
{
    struct points points =
        generate(find_distribution("uniform"), 50000, 1);
    for (int k = 0; k < THREADS; k++) {
        check_generators(10000, 2, k);
        check_generators(5000, 300, k);
        check_generators(2000, 0.05, k);
        test_seed(1);
        check_sorts("uniform", points, 0.04, k);
    }
    points_free(&points);
}

static void same_grid_for_all_threads(void)
{
    for (int d = 0; d < distribution_count; d++) {
        struct points points = generate(&distributions[d], 999, 1);
        struct question question = {points, {STANDARD, 1, 1}, 1};
        struct grid right = grid_fit(&question, 2);
        for (question.threads = 2; question.threads <= 64;
             question.threads *= 2) {
            struct grid found = grid_fit(&question, 2);
            CHECK_INT(right.x.count, found.x.count, "columns");
            CHECK_INT(right.y.count, found.y.count, "rows");
            CHECK_DOUBLE(right.x.low, found.x.low, "left");
            CHECK_DOUBLE(right.y.low, found.y.low, "bottom");
            CHECK_DOUBLE(right.x.scale, found.x.scale, "width");
            CHECK_DOUBLE(right.y.scale, found.y.scale, "height");
            grid_free(&found);
        }
        grid_free(&right);
        points_free(&points);
    }
}

// ---- counting by groups --------------------------------------------
static uint64_t plain_losers(const uint32_t *cell_id, uint32_t n,
                             uint32_t lanes)
{
    uint64_t losers = 0;
    for (uint32_t begin = 0; begin < n; begin += lanes) {
        uint32_t end = n - begin < lanes ? n : begin + lanes;
        for (uint32_t i = begin; i < end; i++)
            for (uint32_t j = begin; j < i; j++)
                if (cell_id[i] == cell_id[j]) {
                    losers++;
                    break;
                }
    }
    return losers;
}

// From counts that are not zero, with whatever is in the scratch array.
static void counts_by_groups(void)
{
    static const uint32_t cells[] = {1, 3, 50, 1000};
    enum { N = 300 };
    for (uint64_t seed = 0; seed < 200; seed++) {
        test_seed(seed);
        struct random random = {seed};
        uint32_t n = random_bits(&random) % (N + 1);
        uint32_t lanes = 1 + random_bits(&random) % (N + 20);
        uint32_t m = cells[random_bits(&random) % 4];
        uint32_t cell_id[N], right[1000] = {0}, found[1000] = {0};
        for (uint32_t k = 0; k < m; k++)
            right[k] = found[k] = random_bits(&random) % 3;
        for (uint32_t i = 0; i < n; i++)
            right[cell_id[i] = random_bits(&random) % m]++;
        struct groups groups = groups_allocate(lanes, m);
        memset(groups.ticket, seed % 256, m * sizeof *groups.ticket);
        uint64_t losers = groups_count(&groups, cell_id, n, found);
        CHECK_INT((long long)plain_losers(cell_id, n, lanes),
                  (long long)losers, "losers of %u points, %u lanes", n,
                  lanes);
        same_numbers(right, found, m, "count", "by groups");
        groups_free(&groups);
    }
}

// Su's figure for all equal points: all but one of every group.
static void collisions_of_equal_points(void)
{
    enum { N = 1000 };
    uint32_t cell_id[N] = {0}, count = 0, next = 0, point[N];
    struct groups groups = groups_allocate(64, 1);
    CHECK_INT(N - 16,
              (long long)groups_count(&groups, cell_id, N, &count),
              "losers of counting");
    CHECK_INT(N, count, "counted");
    CHECK_INT(
        N - 16,
        (long long)groups_place(&groups, cell_id, N, &next, point),
        "losers of placing");
    for (uint32_t i = 0; i < N; i++)
        CHECK_INT(i, point[i], "point[%u]", i);
    groups_free(&groups);
}

// About c (L - 1) / 2 losers in all, however many points. A few, where
// groups are short: so over many sets of points.
static uint64_t losers_of_uniform_points(uint32_t n, double c,
                                         uint32_t lanes, uint64_t seed,
                                         double *per_cell)
{
    struct points points =
        generate(find_distribution("uniform"), n, seed);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct grid grid = grid_fit(&question, c);
    const uint32_t m = grid_cells(&grid);
    struct groups groups = groups_allocate(lanes, m);
    uint32_t *cell_id = allocate(n, sizeof *cell_id);
    uint32_t *count = allocate(m, sizeof *count);
    find_cell_ids(&grid, points, 0, n, cell_id);
    memset(count, 0, m * sizeof *count);
    uint64_t losers = groups_count(&groups, cell_id, n, count);
    *per_cell = (double)n / m;
    free(count);
    free(cell_id);
    groups_free(&groups);
    grid_free(&grid);
    points_free(&points);
    return losers;
}

static void collisions_as_predicted(void)
{
    for (uint32_t lanes = 8; lanes <= 1024; lanes *= 2) {
        double sum = 0, per_cell;
        int sets = 4096 / lanes;
        test_seed(lanes);
        for (int set = 0; set < sets; set++)
            sum += losers_of_uniform_points(20000, 2, lanes,
                                            lanes + set, &per_cell);
        double expected = per_cell * (lanes - 1) / 2;
        CHECK_NEAR(expected, sum / sets, 0.1 * expected,
                   "losers in groups of %u", lanes);
    }
}

static void collisions_are_counted(void)
{
    enum { N = 1000 };
    struct points points = generate(find_distribution("equal"), N, 1);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct answers answers = answers_allocate(N);
    struct counts counts = count_operations(
        find_algorithm("cells-groups"), &question, &answers);
    CHECK_INT(2 * (N - 16), (long long)counts.collisions,
              "collisions of equal points, counted and placed");
    counts = count_operations(find_algorithm("cells-threads"),
                              &question, &answers);
    CHECK_INT(0, (long long)counts.collisions, "collisions of records");
    answers_free(&answers);
    points_free(&points);
}

// With the instruction and without it, where the machine has it.
static void conflict_detection(void)
{
    for (int isa = 0; isa < ISA_COUNT; isa++)
        if (isa_present(isa)) {
            setenv("NEAR_ISA", isa_names[isa], 1);
            check_conflict(conflict_count, conflict_place);
        }
    unsetenv("NEAR_ISA");
}

int main(void)
{
    return RUN_TESTS(
        "ch05-collisions", TEST(same_cells_of_every_length),
        TEST(same_cells_of_many_points), TEST(partition_fits),
        TEST(same_grid_for_all_threads), TEST(counts_by_groups),
        TEST(collisions_of_equal_points), TEST(collisions_as_predicted),
        TEST(collisions_are_counted), TEST(conflict_detection));
}
