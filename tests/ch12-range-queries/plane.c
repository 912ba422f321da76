// Neighbors in the plane: points of every kind, both geometries, every
// number of threads, against a plain sort of all distances; and that
// crowds do not cost squares.
#include "plane.h"
#include "ch12-range-queries/k_nearest_list.h"
#include "ch12-range-queries/plane_neighbors.h"
#include "common/allocate.h"
#include "common/generate.h"
#include "common/min_max.h"
#include "common/workspace.h"
#include "harness.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int threads[] = {1, 2, 4};

// ---- the plain way -------------------------------------------------
// The n - 1 others of point i, in their order.
static void sort_others(const struct question *question, uint32_t i,
                        struct other *others)
{
    const struct points p = question->points;
    uint32_t count = 0;
    for (uint32_t j = 0; j < p.n; j++)
        if (j != i)
            others[count++] = (struct other){closest2(question->space,
                                                      p.x[j] - p.x[i],
                                                      p.y[j] - p.y[i]),
                                             j};
    sort_plainly(others, count);
}

// For all points: those of point i begin at i n.
static struct other *sort_all(const struct question *question)
{
    const uint32_t n = question->points.n;
    struct other *order = allocate((uint64_t)n * n, sizeof *order);
    for (uint32_t i = 0; i < n; i++)
        sort_others(question, i, order + (uint64_t)i * n);
    return order;
}

static uint32_t count_plainly(const struct other *others, uint32_t n,
                              double reach2)
{
    uint32_t count = 0;
    while (count < n - 1 && others[count].distance2 <= reach2)
        count++;
    return count;
}

// ---- the same by an index ------------------------------------------
static struct neighbor_lists lists_for(uint32_t first, uint32_t last,
                                       uint32_t each,
                                       const uint64_t *start)
{
    struct neighbor_lists lists = {first, last, each,
                                   start, NULL, NULL};
    const uint64_t room = list_start(&lists, last);
    lists.index = allocate(room, sizeof *lists.index);
    lists.distance2 = allocate(room, sizeof *lists.distance2);
    return lists;
}

static void lists_free(struct neighbor_lists *lists)
{
    free(lists->index);
    free(lists->distance2);
}

static void check_list(const struct neighbor_lists *lists, uint32_t i,
                       const struct other *others, const char *name)
{
    const uint64_t start = list_start(lists, i);
    const uint32_t count = list_start(lists, i + 1) - start;
    for (uint32_t k = 0; k < count; k++)
        if (!CHECK_INT(others[k].index, lists->index[start + k],
                       "%s: neighbor %u of point %u, %u in all", name,
                       k, i, count) ||
            !CHECK_DOUBLE(others[k].distance2,
                          lists->distance2[start + k],
                          "%s: distance %u of point %u", name, k, i))
            return;
}

// Some points, an index of them, and the others of each in order.
struct setting {
    uint32_t n;
    const struct plane_index *index;
    const struct other *order;
    const char *name;
};

static void check_lists(const struct setting *s,
                        const struct neighbor_lists *lists)
{
    for (uint32_t i = lists->first; i < lists->last; i++)
        check_list(lists, i, s->order + (uint64_t)i * s->n, s->name);
}

static void check_nearest(const struct setting *s, uint32_t k)
{
    const uint32_t n = s->n;
    struct neighbor_lists lists = lists_for(0, n, MIN(k, n - 1), NULL);
    fill_plane_lists(s->index, INFINITY, &lists, NULL);
    check_lists(s, &lists);
    lists_free(&lists);
}

static void check_within(const struct setting *s, double reach2)
{
    const uint32_t n = s->n;
    uint32_t *count = allocate(n, sizeof *count);
    uint64_t *start = allocate(n + 1, sizeof *start);
    count_plane_within(s->index, reach2, count, NULL);
    start[0] = 0;
    for (uint32_t i = 0; i < n; i++) {
        const uint32_t right =
            count_plainly(s->order + (uint64_t)i * n, n, reach2);
        CHECK_INT(right, count[i], "%s: within %g of point %u", s->name,
                  reach2, i);
        start[i + 1] = start[i] + right;
    }
    struct neighbor_lists lists = lists_for(0, n, 0, start);
    fill_plane_lists(s->index, reach2, &lists, NULL);
    check_lists(s, &lists);
    lists_free(&lists);
    free(start);
    free(count);
}

// ---- every kind of points ------------------------------------------
static bool in_unit_square(struct points p)
{
    for (uint32_t i = 0; i < p.n; i++)
        if (p.x[i] < 0 || p.x[i] > 1 || p.y[i] < 0 || p.y[i] > 1)
            return false;
    return true;
}

static void check_some_k(const struct setting *s)
{
    static const uint32_t some[] = {1, 2, 8, 33, 1000};
    for (int k = 0; k < 5; k++)
        check_nearest(s, some[k]);
}

// Distances that some points just have, none, and all.
static void check_some_distances(const struct setting *s)
{
    const uint32_t n = s->n;
    const struct other *others = s->order + (uint64_t)(n / 2) * n;
    check_within(s, 0);
    check_within(s, others[(n - 2) / 20].distance2);
    check_within(s, others[(n - 2) / 3].distance2);
    check_within(s, INFINITY);
}

static void check_points(struct points points, const char *name)
{
    for (int g = STANDARD; g <= WRAPAROUND; g++) {
        if (g == WRAPAROUND && !in_unit_square(points))
            continue;
        struct workspace workspace = {0};
        struct question question = {
            points, {g, 1, 1}, 1, .workspace = &workspace};
        struct other *order = sort_all(&question);
        for (int t = 0; t < 3; t++) {
            question.threads = threads[t];
            const struct plane_index index =
                plane_index_make(&question, &workspace);
            const struct setting s = {points.n, &index, order, name};
            check_some_k(&s);
            check_some_distances(&s);
            workspace_free(&workspace);
        }
        free(order);
    }
}

void neighbors_in_the_plane(void)
{
    static const uint32_t sizes[] = {2, 3, 20, 333};
    for (int row = 0; row < distribution_count; row++)
        for (int size = 0; size < 4; size++) {
            const uint32_t n = at_most("MOST_POINTS", sizes[size]);
            test_seed(size + 1);
            struct points points =
                generate(&distributions[row], n, size + 1);
            check_points(points, distributions[row].name);
            points_free(&points);
        }
}

// ---- blocks --------------------------------------------------------
void lists_by_blocks(void)
{
    enum { N = 500, K = 5, BLOCK = 70 };
    struct workspace workspace = {0};
    struct points points = generate(find_distribution("towns"), N, 7);
    const struct question question = {
        points, {STANDARD, 0, 0}, 2, .workspace = &workspace};
    const struct plane_index index =
        plane_index_make(&question, &workspace);
    struct other *order = sort_all(&question);
    const struct setting s = {N, &index, order, "a block"};
    for (uint32_t first = 0; first < N; first += BLOCK) {
        const uint32_t last = MIN(first + BLOCK, N);
        struct neighbor_lists lists = lists_for(first, last, K, NULL);
        fill_plane_lists(&index, INFINITY, &lists, NULL);
        check_lists(&s, &lists);
        lists_free(&lists);
    }
    free(order);
    workspace_free(&workspace);
    points_free(&points);
}

// ---- the work ------------------------------------------------------
static double work_for(const struct distribution *distribution,
                       uint32_t n)
{
    enum { K = 8 };
    struct workspace workspace = {0};
    struct counts counts = {0};
    struct points points = generate(distribution, n, 3);
    const struct question question = {
        points, {STANDARD, 0, 0}, 1, .workspace = &workspace};
    const struct plane_index index =
        plane_index_make(&question, &workspace);
    struct neighbor_lists lists = lists_for(0, n, K, NULL);
    fill_plane_lists(&index, INFINITY, &lists, &counts);
    lists_free(&lists);
    workspace_free(&workspace);
    points_free(&points);
    return (double)counts.distances + counts.cells;
}

// Four times the points, and hardly more than four times the work.
void crowds_are_no_squares(void)
{
    const uint32_t n = 20000; // of fewer, some kinds are no crowds yet
    for (int row = 0; row < distribution_count; row++) {
        const struct distribution *d = &distributions[row];
        const double few = work_for(d, n), many = work_for(d, 4 * n);
        CHECK(many < 6 * few, "%s: %g steps a point, then %g", d->name,
              few / n, many / (4.0 * n));
        CHECK(many < 200.0 * 4 * n, "%s: %g steps a point", d->name,
              many / (4.0 * n));
    }
}
