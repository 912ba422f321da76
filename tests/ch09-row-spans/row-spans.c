// Row spans: the search in every mode and instruction set against the
// plainest there is; as many distances, and exact queries, as were
// expected; and memory that is kept.
#include "algorithms.h"
#include "ch09-row-spans/check_spans.h"
#include "ch09-row-spans/experiments/expected_spans.h"
#include "ch09-row-spans/portable_batch.h"
#include "ch09-row-spans/row_spans.h"
#include "ch09-row-spans/staging.h"
#include "common/isa.h"
#include "harness.h"
#include "memory.h"
#include <stdlib.h>

// ---- the search ----------------------------------------------------
static void portable_answers(void)
{
    check_spans(&portable_spans);
}

static void avx2_answers(void)
{
#ifdef HAVE_X86_VECTORS
    if (isa_present(AVX2))
        check_spans(&avx2_spans);
#endif
}

static void avx512_answers(void)
{
#ifdef HAVE_X86_VECTORS
    if (isa_present(AVX512))
        check_spans(&avx512_spans);
#endif
}

// Whatever becomes of the order, with any number of threads.
static void order_restored(void)
{
    static const uint32_t lengths[] = {2, 7, 9, 1023, 1025, 5000};
    for (int k = 0; k < 6; k++)
        for (int threads = 1; threads <= 3; threads++) {
            const uint32_t n = lengths[k];
            test_seed(k);
            struct question question = {
                generate(find_distribution("clustered"), n, k),
                {STANDARD, 1, 1},
                threads};
            struct answers right = answers_allocate(n);
            struct answers found = answers_allocate(n);
            search_plainly(&question, &right);
            memset(found.nearest, 0xA5, n * sizeof *found.nearest);
            memset(found.nearest2, 0xA5, n * sizeof *found.nearest2);
            row_spans(&question, &found);
            CHECK_INT(0,
                      memcmp(right.nearest, found.nearest,
                             n * sizeof *found.nearest),
                      "%u points: neighbors", n);
            CHECK_INT(0,
                      memcmp(right.nearest2, found.nearest2,
                             n * sizeof *found.nearest2),
                      "%u points: distances", n);
            answers_free(&found);
            answers_free(&right);
            points_free(&question.points);
        }
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
// the end of a row, whose batches are narrower.
static void counts_as_expected(void)
{
    const uint32_t n = 300000;
    const double c = POINTS_PER_SPAN_CELL;
    struct counts counts = count_uniform(n, 2);
    test_seed(4);
    CHECK_NEAR(expected_exact(c), (double)counts.exact / n,
               0.06 * expected_exact(c), "exact queries");
    CHECK_NEAR(expected_candidates(c), (double)counts.distances / n,
               0.02 * expected_candidates(c), "distances a point");
}

static void counts_of_any_threads(void)
{
    struct counts one = count_uniform(50000, 1);
    for (int threads = 2; threads <= 4; threads++) {
        struct counts counts = count_uniform(50000, threads);
        CHECK_INT((long long)one.exact, (long long)counts.exact,
                  "exact queries, %d threads", threads);
        CHECK_INT((long long)one.distances, (long long)counts.distances,
                  "distances, %d threads", threads);
    }
}

// On a lattice every query has ties, which single precision cannot
// tell apart: all are answered exactly, after a kernel has failed.
static void ties_are_answered_exactly(void)
{
    struct points points =
        generate(find_distribution("lattice"), 1024, 1);
    struct question question = {points, {STANDARD, 1, 1}, 1};
    struct answers answers = answers_allocate(1024);
    struct counts counts = count_operations(find_algorithm("row-spans"),
                                            &question, &answers);
    CHECK_INT(1024, (long long)counts.exact, "exact queries");
    answers_free(&answers);
    points_free(&points);
}

// ---- what single precision is sure of ------------------------------
// Seen in floats, the first of two candidates is nearer, by more than
// the one slack or the other taken alone allows for; in doubles it is
// the second. With 2^-34 in place of 2^-27, or 2^-15 in place of 2^-12,
// the wrong one would be certified. Found among 3e8 random triples: no
// better witness against 2^-33 is known.
struct witness {
    double x[3], y[3]; // the query, the two candidates
};

static const struct witness witnesses[] = {
    {{0x1.3949b4e7d4517p-1, 0x1.39042f22f8b0ep-1, 0x1.39833f00169fcp-1},
     {-0x1.bdcce0bba572dp-1, -0x1.bdb24944032dep-1,
      -0x1.bdfc19032dc29p-1}},
    {{0x1.3491c6708015p-4, 0x1.4a6aeb0c01902p-3, 0x1.6674a3d93677fp-4},
     {-0x1.1f4f4d627d88ap-1, -0x1.14d6cb3f28988p-1,
      -0x1.e4f5f0d349facp-2}}};

static float squares(const struct scene *scene, float dx, float dy)
{
    (void)scene;
    return dx * dx + dy * dy;
}

static double exact2(const struct witness *w, int candidate)
{
    double dx = w->x[candidate] - w->x[0];
    double dy = w->y[candidate] - w->y[0];
    return dx * dx + dy * dy;
}

static void slacks_have_a_reason(void)
{
    static struct staging staging = {.reach = 1};
    const uint32_t places[] = {STAGED, 0, PLACES - 1};
    const struct query_batch batch = {.own = STAGED,
                                      .from = {0, 0, PLACES - 1},
                                      .to = {1, 0, PLACES}};
    for (int k = 0; k < 2; k++) {
        const struct witness *w = &witnesses[k];
        for (int i = 0; i < 3; i++) {
            staging.place_x[places[i]] = (float)w->x[i];
            staging.place_y[places[i]] = (float)w->y[i];
        }
        struct best_two two =
            sweep_plainly(squares, NULL, &staging, &batch);
        CHECK(exact2(w, 2) < exact2(w, 1), "the second is nearer, %d",
              k);
        CHECK_INT(0, (long long)place_of(two.best[0]),
                  "in floats the first, %d", k);
        const float slack = near_slack(&staging);
        CHECK(!is_certain(&two, 0, slack), "it is not certified, %d",
              k);
        bool would = k == 0 ? is_certain(&two, 0, slack * 0x1p-7f)
                            : two.second[0] >
                                  two.best[0] * (1 + 0x1p-15f) + slack;
        CHECK(would, "with less slack it would be, %d", k);
    }
}

// ---- pads ----------------------------------------------------------
// Nothing near that a buffer held before is left where a sweep may look
// beyond a row's candidates, whatever a kernel has written there.
static void check_pads(const struct staging *staging, uint32_t begin)
{
    for (uint32_t k = 0; k < ROWS; k++) {
        const struct staged_row *row = &staging->row[k];
        if (row->start == NULL)
            continue;
        const uint32_t end =
            row->start[staging->last + 1] + row->shift[0];
        for (uint32_t pad = 0; pad < PAD; pad++) {
            CHECK_NEAR(FAR, staging->place_x[k * STAGED + pad], 0,
                       "before row %u from %u on", k, begin);
            CHECK_NEAR(FAR, staging->place_x[end + pad], 0,
                       "behind row %u from %u on", k, begin);
        }
    }
}

static void pads_are_far(void)
{
    enum { N = 2000 };
    struct points points = generate(find_distribution("uniform"), N, 5);
    const struct question question = {points, {STANDARD, 1, 1}, 1};
    struct sorted sorted = sorted_make(&question, POINTS_PER_SPAN_CELL);
    const struct scene scene = {question.space, &sorted,
                                span_kernels()};
    const struct axis *up = &sorted.grid.y;
    const double *y = sorted.points.y;
    int opened = 0;
    for (uint32_t s = 0; s + BATCH <= N; s++) {
        const uint32_t row = axis_cell(up, y[s]);
        static struct staging staging;
        staging = (struct staging){0};
        staging_prepare(&staging, INFINITY);
        if (axis_cell(up, y[s + BATCH - 1]) == row &&
            stage_candidates(&scene, row, s, BATCH, &staging)) {
            check_pads(&staging, s);
            opened++;
        }
    }
    CHECK(opened > N / 2, "%d buffers are opened", opened);
    sorted_free(&sorted);
    points_free(&points);
}

// ---- memory --------------------------------------------------------
static void memory_is_kept(void)
{
    for (int threads = 1; threads <= 2; threads++)
        check_memory_kept("row-spans", threads, 60);
}

int main(void)
{
    return RUN_TESTS(
        "ch09-row-spans", TEST(portable_answers), TEST(avx2_answers),
        TEST(avx512_answers), TEST(order_restored), TEST(many_as_ever),
        TEST(counts_as_expected), TEST(counts_of_any_threads),
        TEST(ties_are_answered_exactly), TEST(slacks_have_a_reason),
        TEST(pads_are_far), TEST(memory_is_kept));
}
