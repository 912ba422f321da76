// The whole time a point, sort and all, of the spiral search, of
// chapter 4's best and of row spans, on one thread, from a thousand
// points on; how many points fill the caches; how many pages of memory
// row spans give back with every run and get again in the next, and
// their time if they keep them in a workspace.
//     heights [MOST]
#include "ch06-pack-scan/experiments/caches.h"
#include "common/experiment.h"
#include <sys/resource.h>

// Coordinates and an index of a sorted point, two thirds of a start,
// two indices to restore its order, and an answer.
enum { BYTES_KEPT = 43, LOTS = 1000000 };

static const char *const searches[] = {"spiral", "cells", "row-spans"};
enum { SEARCHES = 3 };

// What is found out about so many points.
struct height {
    uint32_t n;
    long pages;
    struct trial trial[SEARCHES], kept;
};

static long pages_so_far(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

// Large sets take long, and differ little. What allocates much runs
// once before it is timed; the spiral, long and without such arrays,
// need not. The pages are those that row spans touch for the first
// time, though they have just been run.
static void time_size(struct height *height)
{
    const uint32_t n = height->n;
    struct question question = uniform_question(STANDARD, n, 1);
    struct answers *answers = new_answers(n, NEAREST);
    struct trial *trial = height->trial;
    for (int k = 0; k < SEARCHES; k++) {
        trial[k] = search_trial(find_algorithm(searches[k])->run,
                                &question, answers);
        trial[k].prepare = k ? trial[k].work : NULL;
    }
    time_in_turn(n > LOTS ? 1 : 5, trial, SEARCHES);
    const struct trial *spans = &trial[SEARCHES - 1];
    spans->work(spans->context);
    long before = pages_so_far();
    spans->work(spans->context);
    height->pages = pages_so_far() - before;
    forget();
}

static void time_kept(struct height *height)
{
    struct workspace workspace = {0};
    struct question question = uniform_question(STANDARD, height->n, 1);
    question.workspace = &workspace;
    height->kept =
        search_trial(find_algorithm("row-spans")->run, &question,
                     new_answers(height->n, NEAREST));
    time_in_turn(5, &height->kept, 1);
    workspace_free(&workspace);
    forget();
}

static void print_height(const struct height *height)
{
    const uint32_t n = height->n;
    struct caches caches = caches_of_machine();
    row_begin("n%u\t%u\t%zu\t%zu", n, n, caches.l2 / BYTES_KEPT,
              caches.l3 / BYTES_KEPT);
    for (int k = 0; k < SEARCHES; k++)
        row_times(&height->trial[k].summary, n);
    row_cells("\t%ld", height->pages);
    row_times(&height->kept.summary, n);
    row_end();
}

int main(int argc, char **argv)
{
    struct experiment e = experiment_begin(argc, argv);
    uint32_t most = parameter(&e, "MOST", LOTS, 1000, MANY);
    struct height heights[2 * 10]; // two for each power of ten
    int count = 0;
    for (uint32_t n = 1000; n <= most; n = next_size(n))
        heights[count++].n = n;
    for (int k = 0; k < count; k++)
        time_size(&heights[k]);
    for (int k = 0; k < count; k++)
        time_kept(&heights[k]);
    print_header(&e,
                 "name n l2_points l3_points spiral:3 cells:3 spans:3"
                 " pages kept:3");
    for (int k = 0; k < count; k++)
        print_height(&heights[k]);
}
