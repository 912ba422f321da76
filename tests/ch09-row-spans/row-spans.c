// Row spans: the search in every mode and instruction set against the
// plainest there is; as many distances, and exact queries, as were
// expected; and memory that is kept.
#include "algorithms.h"
#include "ch09-row-spans/check_spans.h"
#include "ch09-row-spans/experiments/expected_spans.h"
#include "ch09-row-spans/row_spans.h"
#include "common/isa.h"
#include "harness.h"
#include <stdlib.h>
#include <sys/resource.h>

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
    CHECK_NEAR(expected_alone(c), (double)counts.tasks / n,
               0.06 * expected_alone(c), "exact queries");
    CHECK_NEAR(expected_shown(c), (double)counts.distances / n,
               0.02 * expected_shown(c), "distances a point");
}

static void counts_of_any_threads(void)
{
    struct counts one = count_uniform(50000, 1);
    for (int threads = 2; threads <= 4; threads++) {
        struct counts counts = count_uniform(50000, threads);
        CHECK_INT((long long)one.tasks, (long long)counts.tasks,
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
    CHECK_INT(1024, (long long)counts.tasks, "exact queries");
    answers_free(&answers);
    points_free(&points);
}

// ---- memory --------------------------------------------------------
static long page_faults(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

// A search with a workspace touches no new page when it is repeated,
// and keeps less than 62 bytes a point for itself: 90 with points and
// answers.
static void memory_is_kept(void)
{
    const uint32_t n = 300000;
    for (int g = STANDARD; g <= WRAPAROUND; g++)
        for (int threads = 1; threads <= 2; threads++) {
            struct workspace workspace = {0};
            struct question question = {
                generate(find_distribution("uniform"), n, 1),
                {g, 1, 1},
                threads,
                .workspace = &workspace};
            struct answers answers = answers_for(n, NEAREST);
            long faults[3] = {0};
            for (int trial = 0; trial < 3; trial++) {
                long before = page_faults();
                row_spans(&question, &answers);
                faults[trial] = page_faults() - before;
            }
            CHECK(faults[1] + faults[2] < 10,
                  "%ld pages touched again, %d threads",
                  faults[1] + faults[2], threads);
            size_t bytes = 0;
            for (int k = 0; k < WORKSPACE_BLOCKS; k++)
                bytes += workspace.block[k].size;
            CHECK(bytes < 60 * (size_t)n, "%zu bytes kept", bytes);
            workspace_free(&workspace);
            answers_free(&answers);
            points_free(&question.points);
        }
}

int main(void)
{
    return RUN_TESTS(
        "ch09-row-spans", TEST(portable_answers), TEST(avx2_answers),
        TEST(avx512_answers), TEST(order_restored), TEST(many_as_ever),
        TEST(counts_as_expected), TEST(counts_of_any_threads),
        TEST(ties_are_answered_exactly), TEST(memory_is_kept));
}
