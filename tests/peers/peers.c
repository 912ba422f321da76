// The contest with other libraries, without any of them: peers made up
// here that are slow, wrong or sorry.
#include "common/experiment.h"
#include "harness.h"
#include "peers/contest.h"
#include "peers/results.h"
#include "peers/strips.h"
#include "ranges.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// ---- a peer that compares every pair -------------------------------
struct pairs {
    const place *point;
    uint32_t n;
};

static int leaves_seen, queries, most_threads;

static void *pairs_build(const place *point, uint32_t n, int leaf_size,
                         int threads)
{
    struct pairs *pairs = allocate(1, sizeof *pairs);
    *pairs = (struct pairs){point, n};
    leaves_seen |= leaf_size;
    most_threads = threads > most_threads ? threads : most_threads;
    return pairs;
}

static void pairs_query(void *built, int threads, uint32_t *nearest,
                        double *nearest2)
{
    const struct pairs *pairs = built;
    (void)threads;
    queries++;
    for (uint32_t i = 0; i < pairs->n; i++) {
        nearest2[i] = INFINITY;
        for (uint32_t j = 0; j < pairs->n; j++) {
            double d2 =
                distance2(pairs->point[j][0] - pairs->point[i][0],
                          pairs->point[j][1] - pairs->point[i][1]);
            if (j != i &&
                d2 <= nearest2[i]) // the last of those that tie
                nearest2[i] = d2, nearest[i] = j;
        }
    }
}

// Point 7 takes the first that comes along.
static void careless_query(void *built, int threads, uint32_t *nearest,
                           double *nearest2)
{
    pairs_query(built, threads, nearest, nearest2);
    nearest[7] = nearest[7] == 0 ? 1 : 0;
}

static void vain_query(void *built, int threads, uint32_t *nearest,
                       double *nearest2)
{
    pairs_query(built, threads, nearest, nearest2);
    nearest[7] = 7, nearest2[7] = 0;
}

static void boasting_query(void *built, int threads, uint32_t *nearest,
                           double *nearest2)
{
    pairs_query(built, threads, nearest, nearest2);
    nearest2[7] *= 0.999;
}

// ---- its contests --------------------------------------------------
static struct peer pairs_peer = {
    "pairs", "1", {1, 2, 4, 8}, true, pairs_build, pairs_query, free};

static const struct rules rules = {1e9, 1e9, 3, 2};

static struct instance some_instance(const char *kind, uint32_t n)
{
    return instance_of(generate(find_distribution(kind), n, 5));
}

static struct program ours(void)
{
    return (struct program){"cells", find_algorithm("cells")->run,
                            NULL};
}

static void same_answers(void)
{
    static const char *const kinds[] = {"uniform", "lattice", "equal"};
    for (int k = 0; k < 3; k++) {
        struct instance instance = some_instance(kinds[k], 300);
        struct answers answers = answers_for(300, NEAREST);
        struct history history[2] = {{0}};
        struct program programs[2] = {ours(),
                                      {"pairs", NULL, &pairs_peer}};
        for (int p = 0; p < 2; p++) {
            queries = most_threads = 0;
            struct result result =
                compete(&programs[p], 4, &rules, &instance, &answers,
                        &history[p]);
            CHECK_INT(3, result.trials, "%s: trials", kinds[k]);
            CHECK_INT(0, result.differ, "%s: differ", kinds[k]);
            CHECK(instance.known, "%s: ground", kinds[k]);
            CHECK(result.threaded, "%s: threads", kinds[k]);
            CHECK(result.one.total.median > 0, "%s: time", kinds[k]);
            CHECK_DOUBLE(result.one.total.min, history[p].last,
                         "%s: history", kinds[k]);
        }
        CHECK_INT(8, queries, "one to warm up and three, twice");
        CHECK_INT(2, most_threads, "most threads");
        answers_free(&answers);
        instance_free(&instance);
    }
}

static void every_leaf(void)
{
    struct instance instance = some_instance("uniform", 50);
    struct answers answers = answers_for(50, NEAREST);
    leaves_seen = 0;
    int leaf_size = best_leaf_size(&pairs_peer, &instance, &answers);
    CHECK_INT(1 + 2 + 4 + 8, leaves_seen, "sum of the sizes tried");
    CHECK(leaf_size == 1 || leaf_size == 2 || leaf_size == 4 ||
              leaf_size == 8,
          "a leaf of %d", leaf_size);
    answers_free(&answers);
    instance_free(&instance);
}

// One thread at a time; and a single trial when patience is short.
static void few_trials(void)
{
    struct instance instance = some_instance("uniform", 100);
    struct answers answers = answers_for(100, NEAREST);
    struct peer alone = pairs_peer;
    alone.threaded = false;
    struct program program = {"alone", NULL, &alone};
    struct history history = {0};
    struct result result =
        compete(&program, 1, &rules, &instance, &answers, &history);
    CHECK(!result.threaded, "asked with several threads");
    struct rules hasty = rules;
    hasty.patience = 1;
    program.peer = &pairs_peer;
    history = (struct history){10, 1};
    result =
        compete(&program, 1, &hasty, &instance, &answers, &history);
    CHECK_INT(1, result.trials, "trials of the hasty");
    CHECK(!result.threaded, "the hasty ask with all threads");
    answers_free(&answers);
    instance_free(&instance);
}

// A hundredfold the last time: expected again, and too long.
static void not_run(void)
{
    struct instance instance = some_instance("uniform", 100);
    struct answers answers = answers_for(100, NEAREST);
    struct program program = {"pairs", NULL, &pairs_peer};
    struct history history = {.last = 2e9, .before = 2e7};
    queries = 0;
    struct result result =
        compete(&program, 1, &rules, &instance, &answers, &history);
    CHECK_INT(0, result.trials, "trials");
    CHECK_INT(0, queries, "queries");
    CHECK(!instance.known, "no program has found anything");
    CHECK_NEAR(2e11, result.expected, 1, "expected");
    CHECK_NEAR(2e11, history.last, 1, "history");
    CHECK_NEAR(2e9, history.before, 1, "history before");
    answers_free(&answers);
    instance_free(&instance);
}

static void ask_wrongly(void *query)
{
    struct instance instance = some_instance("uniform", 100);
    struct answers answers = answers_for(100, NEAREST);
    struct peer peer = pairs_peer;
    peer.query = *(void (**)(void *, int, uint32_t *, double *))query;
    struct program right = ours(), wrong = {"wrong", NULL, &peer};
    struct history history[2] = {{0}};
    struct rules alone = rules;
    alone.threads = 1; // a forked process cannot start others
    compete(&right, 0, &alone, &instance, &answers, &history[0]);
    compete(&wrong, 1, &alone, &instance, &answers, &history[1]);
}

static void wrong_answers(void)
{
    void (*query)(void *, int, uint32_t *, double *) = careless_query;
    CHECK_FAILS("wrong: point 7 has a neighbor at", ask_wrongly, &query,
                "a neighbor that is not the nearest");
    query = vain_query;
    CHECK_FAILS("wrong: 7 is no neighbor of point 7", ask_wrongly,
                &query, "itself");
    query = boasting_query;
    CHECK_FAILS("wrong: point 7 has a neighbor at", ask_wrongly, &query,
                "a distance that is too short");
}

// ---- the order in strips -------------------------------------------
static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void strips(void)
{
    enum { N = 1000, WIDE = 32 }; // 32 is the root of 1000, rounded up
    struct points points = generate(find_distribution("kuzmin"), N, 3);
    struct points sorted = points_in_strips(points);
    double most = -INFINITY;
    for (int begin = 0; begin < N; begin += WIDE) {
        double before = most;
        for (int i = begin; i < N && i < begin + WIDE; i++) {
            CHECK(sorted.x[i] >= before,
                  "point %d is left of its strip", i);
            most = fmax(most, sorted.x[i]);
            CHECK(i == begin || sorted.y[i] >= sorted.y[i - 1],
                  "point %d is below the one before", i);
        }
    }
    qsort(points.y, N, sizeof *points.y, by_value);
    qsort(sorted.y, N, sizeof *sorted.y, by_value);
    CHECK(memcmp(points.y, sorted.y, N * sizeof *points.y) == 0,
          "other points than before");
    points_free(&points);
    points_free(&sorted);
}

// ---- the table -----------------------------------------------------
static int cells_in(const char *line)
{
    int cells = 1;
    for (; *line && *line != '\n'; line++)
        cells += *line == '\t';
    return cells;
}

static void table(void)
{
    char *text;
    size_t size;
    FILE *kept = stdout;
    stdout = open_memstream(&text, &size);
    char *arguments[] = {"compare"};
    print_header(&(struct experiment){1, 1, arguments}, result_columns);
    struct entry ran = {"row-spans", "uniform", "coming", 100, 8};
    struct result result = {.trials = 3, .threaded = true};
    result.one.total = (struct summary){1, 200, 300, 400, 5};
    print_result(&ran, &result);
    struct entry skipped = {"ANN", "kuzmin", "ordered", 10, 4};
    result = (struct result){.expected = 12345};
    print_result(&skipped, &result);
    fclose(stdout);
    stdout = kept;
    const char *head = strstr(text, "\nname\t") + 1;
    const char *first = strchr(head, '\n') + 1;
    const char *second = strchr(first, '\n') + 1;
    CHECK_INT(cells_in(head), cells_in(first), "cells of a row");
    CHECK_INT(cells_in(head), cells_in(second), "of one not run");
    static const char expected[] =
        "row_spans_uniform_100_coming\trow-spans\tuniform\t100\tcoming"
        "\t8\t3\t0\t0\t0\t0\t0\t0\t3\t2\t4\t";
    CHECK(strncmp(first, expected, strlen(expected)) == 0, "found: %s",
          first);
    CHECK(strstr(second, "\t4\t0\tnan\t") &&
              strstr(second, "\t1234\t0"),
          "found: %s", second);
    free(text);
}

int main(void)
{
    return RUN_TESTS(
        "peers", TEST(same_answers), TEST(every_leaf), TEST(few_trials),
        TEST(not_run), TEST(wrong_answers), TEST(strips), TEST(table),
        TEST(wrong_ranges_are_refused), TEST(scipy_answers_rightly),
        TEST(python_may_be_missing));
}
