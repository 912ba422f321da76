// Range queries: every structure, in every dimension, with points of
// every kind and boxes of every kind, against a loop over all points;
// neighbors likewise; points that move; and the parts they are made of.
#include "ch12-range-queries/cell_array.h"
#include "ch12-range-queries/generate_set.h"
#include "ch12-range-queries/kd_tree.h"
#include "ch12-range-queries/order.h"
#include "ch12-range-queries/orthotree.h"
#include "ch12-range-queries/projection.h"
#include "ch12-range-queries/radix_sort.h"
#include "ch12-range-queries/select.h"
#include "ch12-range-queries/structures.h"
#include "ch04-cell-sort/line.h"
#include "common/allocate.h"
#include "common/points.h"
#include "harness.h"
#include "plane.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- ranges --------------------------------------------------------
enum kind {
    ANY,
    WHOLE,
    EMPTY,
    ON_BORDERS,
    A_POINT,
    A_LINE,
    OUTSIDE,
    HALF_SPACE,
    SMALL,
    KINDS
};

static double between(double a, double b, struct random *random)
{
    const double share = random_uniform(random);
    return a * (1 - share) + b * share;
}

// Borders of two points of the set.
static void put_on_borders(struct range *range,
                           const struct point_set *p,
                           struct random *random)
{
    const uint32_t i = random_bits(random) % p->n;
    const uint32_t j = random_bits(random) % p->n;
    for (int k = 0; k < p->d; k++) {
        range->low[k] = fmin(p->x[k][i], p->x[k][j]);
        range->high[k] = fmax(p->x[k][i], p->x[k][j]);
    }
}

static struct range range_of_kind(enum kind kind,
                                  const struct point_set *p,
                                  const struct range *all,
                                  struct random *random)
{
    struct range range = *all;
    const uint32_t i = random_bits(random) % p->n;
    const int axis = random_bits(random) % p->d;
    for (int k = 0; k < p->d && (kind == A_POINT || kind == A_LINE);
         k++)
        if (kind == A_POINT || k != axis)
            range.low[k] = range.high[k] = p->x[k][i];
    for (int k = 0; k < p->d && (kind == ANY || kind == SMALL); k++) {
        const double a = between(all->low[k], all->high[k], random);
        const double b = between(all->low[k], all->high[k], random);
        range.low[k] = fmin(a, b);
        range.high[k] = kind == ANY ? fmax(a, b) : a + (b - a) / 8;
    }
    if (kind == ON_BORDERS)
        put_on_borders(&range, p, random);
    if (kind == EMPTY)
        range.low[axis] = nextafter(range.high[axis], INFINITY);
    if (kind == OUTSIDE) {
        range.low[axis] = nextafter(all->high[axis], INFINITY);
        range.high[axis] = INFINITY;
    }
    if (kind == HALF_SPACE) {
        for (int k = 0; k < p->d; k++) {
            range.low[k] = -INFINITY;
            range.high[k] = INFINITY;
        }
        range.low[axis] = p->x[axis][i];
    }
    return range;
}

// ---- the plainest answers ------------------------------------------
static bool is_in(const struct point_set *p, uint32_t i,
                  const struct range *range)
{
    for (int k = 0; k < p->d; k++)
        if (!(range->low[k] <= p->x[k][i] &&
              p->x[k][i] <= range->high[k]))
            return false;
    return true;
}

// Whether the report holds just the points that are in the range, each
// once. The marks are n zeros, before and after.
static bool is_right(const struct point_set *p,
                     const struct range *range,
                     const struct report *report, uint8_t *mark)
{
    bool right = true;
    for (uint32_t k = 0; k < report->count; k++) {
        const uint32_t i = report->found[k];
        right &= i < p->n && !mark[i];
        if (i < p->n)
            mark[i] = 1;
    }
    for (uint32_t i = 0; i < p->n; i++) {
        right &= mark[i] == is_in(p, i, range);
        mark[i] = 0;
    }
    return right;
}

// ---- structures ----------------------------------------------------
struct bench {
    struct point_set points;
    struct range all;
    uint32_t *found;
    uint8_t *mark;
};

static struct bench bench_of(struct point_set points)
{
    struct bench bench = {points, range_of(&points, 0, points.n),
                          allocate(points.n, sizeof(uint32_t)),
                          allocate(points.n, 1)};
    memset(bench.mark, 0, points.n);
    return bench;
}

static void bench_free(struct bench *bench)
{
    point_set_free(&bench->points);
    free(bench->found);
    free(bench->mark);
}

static void check_queries(const struct bench *bench,
                          const struct structure *structure,
                          const void *built, const char *what)
{
    struct random random = {bench->points.n};
    for (int kind = 0; kind < KINDS; kind++) {
        const struct range range =
            range_of_kind(kind, &bench->points, &bench->all, &random);
        struct report report = {bench->found};
        structure->query(built, &range, &report);
        CHECK(is_right(&bench->points, &range, &report, bench->mark),
              "%s, %s, %u points, %d dimensions, range of kind %d",
              structure->name, what, bench->points.n, bench->points.d,
              kind);
    }
}

// A little, and one of them far.
static void move(struct bench *bench)
{
    struct random random = {5};
    const struct point_set *p = &bench->points;
    for (int k = 0; k < p->d; k++) {
        const double width = bench->all.high[k] - bench->all.low[k];
        for (uint32_t i = 0; i < p->n; i++)
            p->x[k][i] +=
                0.01 * width * (random_uniform(&random) - 0.5);
        p->x[k][p->n / 2] -= 2 * width;
    }
    bench->all = range_of(p, 0, p->n);
}

static void check_structure(const char *kind, uint32_t n, int d,
                            const struct structure *structure)
{
    struct bench bench =
        bench_of(generate_set(find_distribution(kind), n, d, n + d));
    void *built = structure->build(&bench.points, 2);
    check_queries(&bench, structure, built, kind);
    CHECK(structure->bytes(built) < 4000000, "%s, %s: storage",
          structure->name, kind);
    move(&bench);
    built = structure_update(structure, built, &bench.points, 1);
    check_queries(&bench, structure, built, "moved");
    structure->discard(built);
    bench_free(&bench);
}

static void all_structures(void)
{
    static const uint32_t sizes[] = {1, 2, 15, 16, 17, 333};
    for (int row = 0; row < structure_count; row++)
        for (int d = 1; d <= MAX_DIMENSIONS; d++)
            for (int kind = 0; kind < distribution_count; kind++)
                for (int k = 0; k < 6; k++)
                    check_structure(distributions[kind].name, sizes[k],
                                    d, &structures[row]);
}

static void many_points(void)
{
    for (int row = 0; row < structure_count; row++)
        for (int d = 1; d <= MAX_DIMENSIONS; d++) {
            const uint32_t n = at_most("MOST_POINTS", 20000);
            check_structure("uniform", n, d, &structures[row]);
            check_structure("kuzmin", n, d, &structures[row]);
        }
}

// RANGE_QUERIES=1e7 for the longest run.
static void many_queries(void)
{
    const char *wanted = getenv("RANGE_QUERIES");
    const double most = wanted ? atof(wanted) : 20000;
    const double each =
        most / structure_count / MAX_DIMENSIONS / distribution_count;
    struct random random = {11};
    for (int row = 0; row < structure_count; row++)
        for (int d = 1; d <= MAX_DIMENSIONS; d++)
            for (int kind = 0; kind < distribution_count; kind++) {
                struct bench bench = bench_of(
                    generate_set(&distributions[kind], 100, d, 3));
                void *built = structures[row].build(&bench.points, 1);
                uint32_t wrong = 0;
                for (double q = 0; q < each; q++) {
                    struct report report = {bench.found};
                    const struct range range = range_of_kind(
                        random_bits(&random) % KINDS, &bench.points,
                        &bench.all, &random);
                    structures[row].query(built, &range, &report);
                    wrong += !is_right(&bench.points, &range, &report,
                                       bench.mark);
                }
                CHECK_INT(0, wrong, "%s, %s, %d dimensions",
                          structures[row].name,
                          distributions[kind].name, d);
                structures[row].discard(built);
                bench_free(&bench);
            }
}

// ---- neighbors -----------------------------------------------------
// All points but one, the near ones first.
static void sort_all(const struct point_set *p, const double *place,
                     uint32_t self, struct other *order)
{
    for (uint32_t i = 0; i < p->n; i++) {
        double sum = 0;
        for (int k = 0; k < p->d; k++) {
            const double apart = p->x[k][i] - place[k];
            sum += apart * apart;
        }
        order[i] = (struct other){i == self ? INFINITY : sum,
                                  i == self ? NO_INDEX : i};
    }
    sort_plainly(order, p->n);
}

static bool same_neighbors(const struct neighbor_query *query,
                           const struct other *order, uint32_t count)
{
    bool same = query->count == count;
    for (uint32_t k = 0; same && k < count; k++)
        same = query->found[k].index == order[k].index &&
               query->found[k].distance2 == order[k].distance2;
    return same;
}

static void check_place(const struct bench *bench,
                        const struct structure *structure,
                        const void *built, const double *place,
                        uint32_t self)
{
    const struct point_set *p = &bench->points;
    const uint32_t others = p->n - (self != NO_INDEX);
    struct other *order = allocate(p->n, sizeof *order);
    struct found *found = allocate(p->n, sizeof *found);
    sort_all(p, place, self, order);
    for (uint32_t k = 1; k <= p->n; k = 3 * k + 2) {
        struct neighbor_query query = {
            .at = place, .self = self, .found = found};
        want_nearest(&query, k);
        structure->neighbors(built, &query);
        CHECK(same_neighbors(&query, order, k < others ? k : others),
              "%s, %u points, %d dimensions, %u nearest",
              structure->name, p->n, p->d, k);
        const double distance =
            others ? sqrt(order[(k - 1) % others].distance2) : 1;
        want_within(&query, distance);
        structure->neighbors(built, &query);
        sort_found(query.found, query.count);
        uint32_t count = 0;
        while (count < others &&
               order[count].distance2 <= distance * distance)
            count++;
        CHECK(same_neighbors(&query, order, count),
              "%s, %u points, %d dimensions, %u within",
              structure->name, p->n, p->d, count);
    }
    free(order);
    free(found);
}

// From some of the points and from places anywhere, near and far.
static void check_neighbors(const struct bench *bench,
                            const struct structure *structure,
                            const void *built)
{
    const struct point_set *p = &bench->points;
    struct random random = {p->n};
    for (int trial = 0; trial < 6; trial++) {
        double place[MAX_DIMENSIONS];
        const uint32_t i = random_bits(&random) % p->n;
        for (int k = 0; k < p->d; k++) {
            const double low = bench->all.low[k];
            const double width = bench->all.high[k] - low;
            place[k] = trial < 3
                           ? p->x[k][i]
                           : low + width * trial *
                                       (random_uniform(&random) - 0.3);
        }
        check_place(bench, structure, built, place,
                    trial < 2 ? i : NO_INDEX);
    }
}

static void all_neighbors(void)
{
    static const uint32_t sizes[] = {1, 2, 40, 400};
    for (int row = 0; row < structure_count; row++)
        for (int d = 1; structures[row].neighbors && d <= 8; d++)
            for (int kind = 0; kind < distribution_count; kind++)
                for (int k = 0; k < 4; k++) {
                    const struct structure *s = &structures[row];
                    struct bench bench = bench_of(generate_set(
                        &distributions[kind], sizes[k], d, 7));
                    void *built = s->build(&bench.points, 1);
                    check_neighbors(&bench, s, built);
                    move(&bench);
                    built =
                        structure_update(s, built, &bench.points, 1);
                    check_neighbors(&bench, s, built);
                    s->discard(built);
                    bench_free(&bench);
                }
}

static void nearest_of_each(void)
{
    enum { K = 5 };
    const uint32_t n = at_most("MOST_POINTS", 3000);
    struct bench bench =
        bench_of(generate_set(find_distribution("uniform"), n, 3, 1));
    uint32_t *nearest = allocate((size_t)n * K, sizeof *nearest);
    double *nearest2 = allocate((size_t)n * K, sizeof *nearest2);
    struct other *order = allocate(n, sizeof *order);
    for (int row = 0; row < structure_count; row++) {
        const struct structure *s = &structures[row];
        if (!s->walk_order)
            continue;
        void *built = s->build(&bench.points, 2);
        k_nearest_of_all(s, built, K, 3, nearest, nearest2);
        for (uint32_t i = 0; i < n; i += 17) {
            double place[MAX_DIMENSIONS] = {0};
            for (int k = 0; k < 3; k++)
                place[k] = bench.points.x[k][i];
            sort_all(&bench.points, place, i, order);
            bool same = true;
            for (uint32_t k = 0; k < K; k++)
                same &=
                    nearest[(size_t)i * K + k] == order[k].index &&
                    nearest2[(size_t)i * K + k] == order[k].distance2;
            CHECK(same, "%s, point %u", s->name, i);
        }
        s->discard(built);
    }
    free(nearest);
    free(nearest2);
    free(order);
    bench_free(&bench);
}

// ---- parts ---------------------------------------------------------
static void selection(void)
{
    enum { MOST = 5000 };
    static double x[MOST], sorted[MOST], room[2 * MOST];
    struct random random = {3};
    for (uint32_t n = 1; n <= MOST; n += n / 3 + 1)
        for (int kind = 0; kind < 4; kind++) {
            for (uint32_t i = 0; i < n; i++) {
                const double value = random_uniform(&random);
                x[i] = kind == 0   ? value
                       : kind == 1 ? floor(4 * value)
                       : kind == 2 ? i
                                   : (i % 2 ? 1 : value);
            }
            memcpy(sorted, x, sizeof x);
            sort_numbers(sorted, n);
            for (uint32_t rank = 0; rank < n; rank += n / 7 + 1)
                CHECK_DOUBLE(sorted[rank],
                             select_rank(x, n, rank, room),
                             "rank %u of %u, kind %d", rank, n, kind);
        }
}

static void keys(void)
{
    static const double x[] = {-INFINITY, -1e300, -1,    -1e-310, 0,
                               1e-310,    1,      1e300, INFINITY};
    for (int k = 1; k < 9; k++)
        CHECK(radix_key(x[k - 1]) < radix_key(x[k]), "key of %g", x[k]);
    CHECK(radix_key(-0.0) == radix_key(0.0), "two zeros");

    enum { N = 3000 };
    static struct radix_record record[N], room[N];
    struct random random = {9};
    for (uint32_t i = 0; i < N; i++)
        record[i] =
            (struct radix_record){random_bits(&random) >> 20 & ~7u, i};
    radix_sort(record, N, 44, room);
    for (uint32_t i = 1; i < N; i++)
        CHECK(record[i - 1].key < record[i].key ||
                  (record[i - 1].key == record[i].key &&
                   record[i - 1].point < record[i].point),
              "record %u", i);
}

// ---- what the structures promise -----------------------------------
static void threads_make_the_same_tree(void)
{
    const uint32_t n = at_most("MOST_POINTS", 40000);
    struct point_set points =
        generate_set(find_distribution("clustered"), n, 3, 4);
    struct kd_tree one = kd_make(&points, KD_LEAF_SIZE, 1);
    struct kd_tree four = kd_make(&points, KD_LEAF_SIZE, 4);
    CHECK_INT(one.depth, four.depth, "depth");
    CHECK(memcmp(one.sorted.index, four.sorted.index,
                 n * sizeof *one.sorted.index) == 0,
          "the same order");
    CHECK(memcmp(one.axis + 1, four.axis + 1, one.leaves - 1) == 0,
          "the same axes");
    kd_free(&one);
    kd_free(&four);
    point_set_free(&points);
}

static void leaves_are_filled_evenly(void)
{
    for (uint32_t n = 1; n < 300; n++) {
        struct point_set points =
            generate_set(find_distribution("equal"), n, 2, 4);
        for (uint32_t leaf = 2; leaf < 20; leaf += 5) {
            struct kd_tree tree = kd_make(&points, leaf, 1);
            uint32_t min = n, max = 0;
            for (uint32_t l = 0; l < tree.leaves; l++) {
                const struct span span = kd_leaf(&tree, l);
                const uint32_t count = span.end - span.begin;
                min = count < min ? count : min;
                max = count > max ? count : max;
            }
            CHECK(min >= 1 && max <= leaf && max - min <= 1,
                  "%u points, leaves of %u: %u to %u", n, leaf, min,
                  max);
            kd_free(&tree);
        }
        point_set_free(&points);
    }
}

// A range that is so and so wide, with points at two of its corners.
static void check_counts(int d, const double *width, double wanted,
                         const uint32_t *expected)
{
    struct point_set points = point_set_allocate(2, d);
    for (int k = 0; k < d; k++) {
        points.x[k][0] = 0;
        points.x[k][1] = width[k];
    }
    struct cell_array cells =
        cell_array_make(&points, 2 / wanted, false);
    for (int k = 0; k < d; k++)
        CHECK_INT(expected[k], cells.count[k],
                  "%g cells, coordinate %d", wanted, k);
    cell_array_free(&cells);
    point_set_free(&points);
}

// Where the cells wanted make cubes without a remainder they are made,
// whatever way logarithms are rounded.
static void cubes_without_a_remainder(void)
{
    check_counts(2, (double[]){8, 0.5}, 16, (uint32_t[]){16, 1});
    check_counts(2, (double[]){0.5, 8}, 16, (uint32_t[]){1, 16});
    check_counts(3, (double[]){1, 1, 1}, 1000,
                 (uint32_t[]){10, 10, 10});
    for (int d = 1; d <= 4; d++)
        for (uint32_t side = 1; pow(side, d) <= 20000;
             side += 1 + side / 200) {
            const double w = 0.1 * d;
            check_counts(d, (double[]){w, w, w, w}, pow(side, d),
                         (uint32_t[]){side, side, side, side});
        }
}

// Nothing is looked at that lies inside.
static void whole_ranges_are_not_looked_at(void)
{
    struct bench bench = bench_of(
        generate_set(find_distribution("uniform"), 5000, 3, 4));
    for (int row = 3; row < structure_count; row++) {
        void *built = structures[row].build(&bench.points, 1);
        struct report report = {bench.found};
        structures[row].query(built, &bench.all, &report);
        CHECK_INT(5000, report.count, "%s", structures[row].name);
        CHECK_INT(0, report.tested, "%s", structures[row].name);
        structures[row].discard(built);
    }
    bench_free(&bench);
}

static void close_points_share_a_leaf(void)
{
    struct point_set points =
        generate_set(find_distribution("equal"), 1000, 2, 4);
    struct orthotree plain =
        ortho_make(&points, ORTHO_LEAF_SIZE, false);
    struct orthotree compressed =
        ortho_make(&points, ORTHO_LEAF_SIZE, true);
    points.x[0][0] += 1e-9;
    struct orthotree close = ortho_make(&points, ORTHO_LEAF_SIZE, true);
    CHECK(plain.count <= 1 + 4 * MAX_LEVELS, "%u nodes", plain.count);
    CHECK_INT(1, compressed.count, "nodes of one place");
    CHECK_INT(3, close.count, "nodes of two places");
    ortho_free(&plain);
    ortho_free(&compressed);
    ortho_free(&close);
    point_set_free(&points);
}

static void small_moves_are_repaired(void)
{
    enum { N = 1000 };
    struct point_set points =
        generate_set(find_distribution("uniform"), N, 2, 4);
    struct projection projection = projection_make(&points);
    CHECK_INT(0, projection_update(&projection), "nothing moved");
    points.x[0][projection.order[0][0]] = 2;
    CHECK_INT(N - 1, projection_update(&projection), "one to the end");
    for (uint32_t i = 0; i < N; i++)
        points.x[1][i] = -points.x[1][i];
    CHECK(projection_update(&projection) > (uint64_t)MAX_SHIFTS * N,
          "all turned round");
    for (int k = 0; k < 2; k++)
        for (uint32_t r = 1; r < N; r++)
            CHECK(points.x[k][projection.order[k][r - 1]] <=
                      points.x[k][projection.order[k][r]],
                  "coordinate %d, place %u", k, r);
    projection_free(&projection);
    point_set_free(&points);
}

int main(void)
{
    return RUN_TESTS(
        "ch12-range-queries", TEST(all_structures), TEST(many_points),
        TEST(many_queries), TEST(all_neighbors), TEST(nearest_of_each),
        TEST(selection), TEST(keys), TEST(threads_make_the_same_tree),
        TEST(leaves_are_filled_evenly), TEST(cubes_without_a_remainder),
        TEST(whole_ranges_are_not_looked_at),
        TEST(close_points_share_a_leaf), TEST(small_moves_are_repaired),
        TEST(neighbors_in_the_plane), TEST(lists_by_blocks),
        TEST(crowds_are_no_squares));
}
