// The whole time a point, sort and all, of the spiral search, of
// chapter 4's best and of row spans, on one thread, from a thousand
// points on; how many points fill the caches, if a search needs what
// row spans keep of a point; how many pages of memory row spans give
// back to the system with every run and get again in the next, if they
// are given no workspace; and what they take if they are given one.
//
//     heights [MOST]
#include "algorithms.h"
#include "ch06-pack-scan/experiments/caches.h"
#include "common/experiment.h"
#include "common/workspace.h"
#include <sys/resource.h>

// Coordinates and an index of a sorted point, two thirds of a start,
// the way back, and an answer.
enum { BYTES_KEPT = 43, LOTS = 1000000 };

static const struct {
    const char *algorithm;
} searches[] = {{"spiral"}, {"cells"}, {"row-spans"}};
enum { SEARCHES = 3 };

// The pages that a search touches for the first time, though it has
// just been run.
static long pages_again(struct search *search)
{
    struct rusage before, after;
    run_search(search);
    getrusage(RUSAGE_SELF, &before);
    run_search(search);
    getrusage(RUSAGE_SELF, &after);
    return after.ru_minflt - before.ru_minflt;
}

// What is found out about so many points.
struct height {
    uint32_t n;
    long pages;
    struct summary summary[SEARCHES], kept;
};

// Large sets take long, and differ little. What allocates much runs
// once before it is timed; the spiral, long and without such arrays,
// need not.
static void time_size(struct height *height)
{
    const uint32_t n = height->n;
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers answers = answers_for(n, NEAREST);
    struct search search[SEARCHES];
    struct trial trial[SEARCHES];
    for (int k = 0; k < SEARCHES; k++) {
        search[k] =
            (struct search){find_algorithm(searches[k].algorithm)->run,
                            question, &answers};
        trial[k] = (struct trial){.work = run_search,
                                  .prepare = k ? run_search : NULL,
                                  .context = &search[k]};
    }
    time_in_turn(n > LOTS ? 1 : 5, trial, SEARCHES);
    for (int k = 0; k < SEARCHES; k++)
        height->summary[k] = trial[k].summary;
    height->pages = pages_again(&search[SEARCHES - 1]);
    answers_free(&answers);
    points_free(&question.points);
}

static void time_kept(struct height *height)
{
    struct question question = uniform_question(STANDARD, height->n, 1);
    struct workspace workspace = {0};
    question.workspace = &workspace;
    struct answers answers = answers_for(height->n, NEAREST);
    struct search search = {
        find_algorithm(searches[SEARCHES - 1].algorithm)->run, question,
        &answers};
    height->kept = time_trials(5, run_search, &search);
    workspace_free(&workspace);
    answers_free(&answers);
    points_free(&question.points);
}

static void print_height(const struct height *height)
{
    const uint32_t n = height->n;
    struct caches caches = caches_of_machine();
    row_begin("n%u\t%u\t%zu\t%zu", n, n, caches.l2 / BYTES_KEPT,
              caches.l3 / BYTES_KEPT);
    for (int k = 0; k < SEARCHES; k++)
        row_times(&height->summary[k], n);
    row_cells("\t%ld", height->pages);
    row_times(&height->kept, n);
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", LOTS, 1000, MANY);
    struct height heights[2 * 10]; // two for each power of ten
    int count = 0;
    for (uint64_t n = 1000; n <= most; n *= 10)
        for (int third = 0; third < 2; third++)
            if ((third ? 3 * n : n) <= most)
                heights[count++].n = third ? 3 * n : n;
    for (int k = 0; k < count; k++)
        time_size(&heights[k]);
    for (int k = 0; k < count; k++)
        time_kept(&heights[k]);
    columns(&e, "name n l2_points l3_points spiral:3 cells:3 spans:3"
                " pages kept:3");
    for (int k = 0; k < count; k++)
        print_height(&heights[k]);
    return 0;
}
