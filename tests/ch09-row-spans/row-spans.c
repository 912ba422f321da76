// Row spans: the sort that carries the points against the plain one;
// the search in every manner and instruction set against the plainest
// there is; and as many distances, and points alone, as were expected.
#include "algorithms.h"
#include "ch09-row-spans/avx2_spans.h"
#include "ch09-row-spans/avx512_spans.h"
#include "ch09-row-spans/check_spans.h"
#include "ch09-row-spans/expected_spans.h"
#include "ch09-row-spans/portable_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/isa.h"
#include "harness.h"
#include <stdio.h>
#include <stdlib.h>

// ---- the sort ------------------------------------------------------
static void check_same(const struct sorted *right,
                       const struct sorted *found, const char *what)
{
    const uint32_t m = grid_cells(&right->grid), n = right->points.n;
    CHECK_INT(m, grid_cells(&found->grid), "%s: cells", what);
    CHECK_INT(0,
              memcmp(right->cells.start, found->cells.start,
                     ((size_t)m + 1) * sizeof *right->cells.start),
              "%s: where the cells begin", what);
    CHECK_INT(0,
              memcmp(right->cells.point, found->cells.point,
                     n * sizeof *right->cells.point),
              "%s: numbers", what);
    CHECK_INT(
        0, memcmp(right->points.x, found->points.x, n * sizeof(double)),
        "%s: x", what);
    CHECK_INT(
        0, memcmp(right->points.y, found->points.y, n * sizeof(double)),
        "%s: y", what);
}

// Whoever stands at a place came in the parcel he was sent in.
static void check_parcels(const struct carried *carried,
                          const char *what)
{
    const uint32_t n = carried->sorted.points.n;
    for (uint32_t s = 0; s < n; s++)
        if (!CHECK_INT(carried->sent[carried->sorted.cells.point[s]],
                       carried->came[s], "%s: parcel to place %u", what,
                       s))
            return; // one is enough
}

static void carried_as_sorted(void)
{
    static const uint32_t lengths[] = {2, 3, 100, 511, 513, 40000};
    static const int threads[] = {1, 2, 3, 4, 7, 64};
    static const double c[] = {0.05, 1.5, 30};
    char what[100];
    for (int d = 0; d < distribution_count; d++)
        for (int k = 0; k < 6; k++) {
            test_seed(k);
            struct question question = {
                generate(&distributions[d], lengths[k], k),
                {STANDARD, 1, 1},
                1};
            for (int each = 0; each < 3; each++) {
                question.threads = 1;
                struct sorted right =
                    sorted_make(&question, c[each], cells_sort_alone);
                for (int t = 0; t < 6; t++) {
                    question.threads = threads[t];
                    struct carried found =
                        carry_points(&question, c[each]);
                    snprintf(what, sizeof what,
                             "%u %s points, c %g, %d threads",
                             lengths[k], distributions[d].name, c[each],
                             threads[t]);
                    check_same(&right, &found.sorted, what);
                    check_parcels(&found, what);
                    carried_free(&found);
                }
                sorted_free(&right);
            }
            points_free(&question.points);
        }
}

// ---- the search ----------------------------------------------------
static void portable_answers(void)
{
    check_spans(portable_spans, "portable");
}

static void avx2_answers(void)
{
#ifdef HAVE_X86_VECTORS
    if (isa_present(AVX2))
        check_spans(avx2_spans, "avx2");
#endif
}

static void avx512_answers(void)
{
#ifdef HAVE_X86_VECTORS
    if (isa_present(AVX512))
        check_spans(avx512_spans, "avx512");
#endif
}

static void turns_of_any_length(void)
{
    const uint32_t n = 5000;
    test_seed(7);
    struct points points = generate(find_distribution("uniform"), n, 7);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct sorted sorted = sorted_make(&question, 2, cells_sort_alone);
    struct answers right = answers_allocate(n);
    struct answers found = answers_allocate(n);
    search_plainly(&question, &right);
    for (uint32_t length = 1; length <= LONGEST_TURN; length *= 2) {
        question.threads = length % 3 + 1;
        memset(found.nearest, 0xA5, n * sizeof *found.nearest);
        memset(found.nearest2, 0xA5, n * sizeof *found.nearest2);
        search_in_turns(&question, &sorted, length, &found);
        CHECK_INT(0,
                  memcmp(right.nearest, found.nearest,
                         n * sizeof *found.nearest),
                  "turns of %u: neighbors", length);
        CHECK_INT(0,
                  memcmp(right.nearest2, found.nearest2,
                         n * sizeof *found.nearest2),
                  "turns of %u: distances", length);
    }
    answers_free(&found);
    answers_free(&right);
    sorted_free(&sorted);
    points_free(&points);
}

// The fourth chapter's search, which has faced the plainest one.
static void many_as_ever(void)
{
    test_seed(8);
    struct question question = {
        generate(find_distribution("clustered"), 300000, 8),
        {STANDARD, 1, 1},
        2};
    struct answers right = answers_allocate(300000);
    struct answers found = answers_allocate(300000);
    find_algorithm("cells-threads")->run(&question, &right);
    row_spans(&question, &found);
    CHECK_INT(
        0,
        memcmp(right.nearest, found.nearest, 300000 * sizeof(uint32_t)),
        "neighbors");
    CHECK_INT(
        0,
        memcmp(right.nearest2, found.nearest2, 300000 * sizeof(double)),
        "distances");
    answers_free(&found);
    answers_free(&right);
    points_free(&question.points);
}

// ---- counts --------------------------------------------------------
static struct counts count_uniform(uint32_t n, int threads)
{
    struct points points = generate(find_distribution("uniform"), n, 4);
    struct question question = {points, {WRAPAROUND, 1, 1}, threads};
    struct answers answers = answers_allocate(n);
    struct counts counts = count_operations(find_algorithm("row-spans"),
                                            &question, &answers);
    answers_free(&answers);
    points_free(&points);
    return counts;
}

// Without a border the expectation holds for all points but those at
// the end of a row, whose tiles are narrower.
static void counts_as_expected(void)
{
    const uint32_t n = 300000;
    const double c = POINTS_PER_SPAN_CELL;
    struct counts counts = count_uniform(n, 2);
    test_seed(4);
    CHECK_NEAR(expected_alone(c), (double)counts.tasks / n,
               0.06 * expected_alone(c), "points that ask alone");
    CHECK_NEAR(expected_shown(c), (double)counts.distances / n,
               0.02 * expected_shown(c), "distances a point");
}

static void counts_of_any_threads(void)
{
    struct counts one = count_uniform(50000, 1);
    for (int threads = 2; threads <= 4; threads++) {
        struct counts counts = count_uniform(50000, threads);
        CHECK_INT((long long)one.tasks, (long long)counts.tasks,
                  "alone, %d threads", threads);
        CHECK_INT((long long)one.distances, (long long)counts.distances,
                  "distances, %d threads", threads);
    }
}

// On a lattice everybody has ties, which single precision cannot
// settle: all ask alone, after they have asked together.
static void ties_ask_alone(void)
{
    struct points points =
        generate(find_distribution("lattice"), 1024, 1);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct answers answers = answers_allocate(1024);
    struct counts counts = count_operations(find_algorithm("row-spans"),
                                            &question, &answers);
    CHECK_INT(1024, (long long)counts.tasks, "alone");
    answers_free(&answers);
    points_free(&points);
}

int main(void)
{
    return RUN_TESTS("ch09-row-spans", TEST(carried_as_sorted),
                     TEST(portable_answers), TEST(avx2_answers),
                     TEST(avx512_answers), TEST(turns_of_any_length),
                     TEST(many_as_ever), TEST(counts_as_expected),
                     TEST(counts_of_any_threads), TEST(ties_ask_alone));
}
